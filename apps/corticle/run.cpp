// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <array>

#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/run_folder.hpp"

namespace corticle
{

int run_command(const RunArguments& arguments)
{
    study::exit_when_interrupted();
    record::RunRequest request;
    request.options = config::read_case(arguments.case_file, arguments.overrides);
    config::identify_inputs(request.options);
    request.out = arguments.out.empty() ? std::filesystem::path("runs") / arguments.case_file.stem() : arguments.out;
    std::error_code error;
    request.body = std::filesystem::is_directory(arguments.body, error) ? arguments.body / "body.h5" : arguments.body;
    request.threads = arguments.threads;
    request.resume = arguments.resume;
    request.overwrite = arguments.overwrite;
    request.quiet = arguments.quiet;
    return study::simulate(request) == model::RunStatus::completed ? exit_status::done : exit_status::interrupted;
}

} // namespace corticle
