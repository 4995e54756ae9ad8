// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/progress.hpp"

#include "corticle/base/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace corticle::record
{

namespace
{
constexpr double redraw_s = 0.5;
} // namespace

Progress::Progress(const model::Simulation& simulation, double t_end, bool quiet)
    : shown_(!quiet && isatty(STDERR_FILENO) == 1), t_end_(t_end),
      area_0_(surface_area(simulation.model().surface.vertices, simulation.model().surface.triangles)),
      drawn_at_(Clock::now()), t_drawn_(simulation.state().t), steps_drawn_(simulation.state().steps)
{
}

void Progress::on_step(const model::Simulation& simulation)
{
    if (!shown_)
    {
        return;
    }
    const double since = std::chrono::duration<double>(Clock::now() - drawn_at_).count();
    if (since < redraw_s)
    {
        return;
    }
    const model::State& state = simulation.state();
    const std::vector<Vec3> x = simulation.surface_positions();
    const double left = (t_end_ - state.t) / std::max((state.t - t_drawn_) / since, 1e-12);
    const int width = static_cast<int>(24.0 * state.t / t_end_);
    show(stderr,
         fmt::format("\r[{:=<{}}{: <{}}] t {:.4f}  step {}  {:.0f} steps/s  {:.0f}:{:02.0f} left  area x{:.3f}  J >= "
                     "{:.3f} \033[K",
                     "", width, "", 24 - width, state.t, state.steps,
                     static_cast<double>(state.steps - steps_drawn_) / since, std::floor(left / 60.0),
                     std::fmod(left, 60.0), surface_area(x, simulation.model().cloud.surface_triangles) / area_0_,
                     simulation.internal().smallest_J));
    drawn_at_ = Clock::now();
    t_drawn_ = state.t;
    steps_drawn_ = state.steps;
}

void Progress::clear() const
{
    if (shown_)
    {
        show(stderr, "\r\033[K");
    }
}

} // namespace corticle::record
