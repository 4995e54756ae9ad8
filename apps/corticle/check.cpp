// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/study/run_folder.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle
{

int check_command(const CheckArguments& arguments)
{
    const config::Options options = config::read_case(arguments.case_file, arguments.overrides);
    const study::Plan planned = study::plan(options, arguments.threads);
    fmt::print("{}\n{}", config::to_toml(options), planned.text);
    if (planned.text.empty() || planned.text.back() != '\n')
    {
        fmt::print("\n");
    }
    for (const std::string& warning : config::case_warnings(options))
    {
        fmt::print("warning: {}\n", warning);
    }
    return exit_status::done;
}

} // namespace corticle
