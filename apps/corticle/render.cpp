// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/view/run_pictures.hpp"

namespace corticle
{

int render_command(const RenderArguments& arguments)
{
    view::render_run(arguments.run_folder);
    return exit_status::done;
}

} // namespace corticle
