// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/report/run_ending.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/run_folder.hpp"

#include <fmt/format.h>

namespace corticle
{

int run_command(RunArguments arguments)
{
    study::exit_when_interrupted();
    record::RunRequest& request = arguments.request;
    request.options = config::read_case(arguments.case_file, arguments.overrides);
    config::identify_inputs(request.options);
    if (request.out.empty())
    {
        request.out = std::filesystem::path("runs") / arguments.case_file.stem();
    }
    std::error_code error;
    if (std::filesystem::is_directory(request.body, error))
    {
        request.body /= "body.h5";
    }
    if (study::simulate(request) != model::RunStatus::completed)
    {
        return exit_status::interrupted;
    }
    if (request.options.output.report == config::PictureRule::on)
    {
        write_report_beside(request.out, request.quiet);
    }
    if (!request.quiet)
    {
        fmt::print("{}", report::run_ending(request.out));
    }
    return exit_status::done;
}

} // namespace corticle
