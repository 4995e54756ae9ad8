// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace corticle
{

bool write_report_beside(const std::filesystem::path& folder, bool is_quiet)
{
    try
    {
        report::write_report({folder});
        return true;
    }
    catch (const std::exception& error)
    {
        if (!is_quiet)
        {
            fmt::print(stderr, "corticle: warning: {}\n", error.what());
        }
        return false;
    }
}

int report_command(const report::ReportRequest& request)
{
    fmt::print("wrote {}\n", report::write_report(request).string());
    return exit_status::done;
}

} // namespace corticle
