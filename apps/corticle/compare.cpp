// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace corticle
{

int compare_command(const CompareArguments& arguments)
{
    const study::ComparisonOutcome outcome = study::compare(arguments.request);
    for (const std::string& warning : outcome.warnings)
    {
        std::fprintf(stderr, "corticle: warning: %s\n", warning.c_str());
    }
    if (outcome.pictures.files.empty())
    {
        std::fprintf(stderr, "corticle: warning: no pictures: %s\n", outcome.pictures.reason.c_str());
    }
    const bool has_page = arguments.report && outcome.has_page && write_report_beside(outcome.folder, false);
    if (arguments.json)
    {
        fmt::print("{}", outcome.json);
    }
    else
    {
        fmt::print("{}wrote {}\n", outcome.summary, (outcome.folder / "report.md").string());
        if (has_page)
        {
            fmt::print("open {}\n", (outcome.folder / report::report_file).string());
        }
    }
    return exit_status::done;
}

} // namespace corticle
