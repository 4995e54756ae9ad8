// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

namespace corticle
{

int report_command(const report::ReportRequest& request)
{
    fmt::print("wrote {}\n", report::write_report(request).string());
    return exit_status::done;
}

} // namespace corticle
