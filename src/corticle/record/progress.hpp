// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"

#include <chrono>

namespace corticle
{

/// A line on the terminal that follows a run: t, step, steps per second, time left, area ratio, J range.
/// Silent when stderr is not a terminal or `quiet` is set.
class Progress
{
  public:
    Progress(const Simulation& simulation, double t_end, bool quiet);
    /// Redraws at most a few times a second.
    void update(const Simulation& simulation);
    /// Ends the line, so that other output starts on a fresh one.
    void clear() const;

  private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    double t_end_;
    double area_0_;
    Clock::time_point drawn_at_;
    double t_drawn_;
    std::int64_t steps_drawn_;
};

} // namespace corticle
