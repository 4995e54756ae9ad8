// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

namespace corticle
{

int export_command(const study::ExportRequest& request)
{
    for (const study::ExportedFrame& frame : study::export_run(request))
    {
        fmt::print("t = {}{}: {}\n", frame.t,
                   frame.asked.empty() ? "" : fmt::format(" (nearest to {})", fmt::join(frame.asked, ", ")),
                   fmt::join(frame.files, " "));
    }
    return exit_status::done;
}

} // namespace corticle
