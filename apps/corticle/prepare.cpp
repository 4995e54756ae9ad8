// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/preparation_folder.hpp"

#include <fmt/format.h>

namespace corticle
{

int prepare_command(const PrepareArguments& arguments)
{
    study::exit_when_interrupted();
    study::PrepareRequest request;
    request.options = config::read_case(arguments.case_file, arguments.overrides);
    config::identify_inputs(request.options);
    request.out =
        arguments.out.empty() ? std::filesystem::path("prepared") / arguments.case_file.stem() : arguments.out;
    request.threads = arguments.threads;
    request.overwrite = arguments.overwrite;
    request.compare_thesis = arguments.compare_thesis;
    const std::string report = study::prepare(request);
    if (!arguments.quiet)
    {
        fmt::print("{}wrote         {}\n", report, request.out.string());
    }
    return exit_status::done;
}

} // namespace corticle
