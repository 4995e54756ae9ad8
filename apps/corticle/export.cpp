// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/study/export.hpp"

#include <fmt/format.h>

namespace corticle
{

int export_command(const ExportArguments& arguments)
{
    const std::vector<study::ExportedFrame> frames =
        study::export_run({arguments.run_folder, arguments.format, arguments.times, arguments.out, arguments.overwrite,
                           arguments.structure});
    for (const study::ExportedFrame& frame : frames)
    {
        fmt::print("t = {}{}: {}\n", frame.t,
                   frame.asked.empty() ? "" : fmt::format(" (nearest to {})", fmt::join(frame.asked, ", ")),
                   fmt::join(frame.files, " "));
    }
    return exit_status::done;
}

} // namespace corticle
