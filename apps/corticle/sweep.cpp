// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/study/interruption.hpp"

namespace corticle
{

int sweep_command(sweep::SweepRequest request)
{
    study::exit_when_interrupted();
    request.out = request.out.empty() ? std::filesystem::path("runs") / request.file.stem() : request.out;
    return sweep::sweep(request) == model::RunStatus::completed ? exit_status::done : exit_status::interrupted;
}

} // namespace corticle
