// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/run_folder.hpp"

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
    return study::simulate(request) == model::RunStatus::completed ? exit_status::done : exit_status::interrupted;
}

} // namespace corticle
