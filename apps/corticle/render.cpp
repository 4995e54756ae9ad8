// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/view/run_pictures.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace corticle
{

int render_command(const view::FigureRequest& request)
{
    if (!request.is_asked())
    {
        view::render_run(request.run);
        return exit_status::done;
    }
    const view::FigureOutcome outcome = view::render_figures(request);
    for (const std::filesystem::path& file : outcome.files)
    {
        fmt::print("wrote {}\n", file.string());
    }
    for (const std::string& note : outcome.notes)
    {
        fmt::print(stderr, "corticle: warning: {}\n", note);
    }
    return exit_status::done;
}

} // namespace corticle
