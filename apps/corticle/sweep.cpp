// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/study/interruption.hpp"

#include <fmt/format.h>

namespace corticle
{

int sweep_command(SweepArguments arguments)
{
    study::exit_when_interrupted();
    sweep::SweepRequest& request = arguments.request;
    request.out = request.out.empty() ? std::filesystem::path("runs") / request.file.stem() : request.out;
    if (sweep::sweep(request) != model::RunStatus::completed)
    {
        return exit_status::interrupted;
    }
    const bool gathers = request.gather || request.engine == sweep::Engine::local;
    if (arguments.report && gathers && !request.list && !request.cases_only &&
        write_report_beside(request.out, request.quiet) && !request.quiet)
    {
        fmt::print("open {}\n", (request.out / report::report_file).string());
    }
    return exit_status::done;
}

} // namespace corticle
