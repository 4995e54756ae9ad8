// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_folder.hpp"
#include "commands.hpp"

#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/study/interruption.hpp"

#include <fmt/format.h>

namespace corticle
{

int prepare_command(PrepareArguments arguments)
{
    study::exit_when_interrupted();
    study::PrepareRequest& request = arguments.request;
    request.out = chosen_folder(request.out, "prepared", arguments.case_file);
    request.options = config::read_case(arguments.case_file, arguments.overrides);
    config::identify_inputs(request.options);
    const std::string report = study::prepare(request);
    if (!arguments.quiet)
    {
        fmt::print("{}wrote         {}\n", report, request.out.string());
    }
    return exit_status::done;
}

} // namespace corticle
