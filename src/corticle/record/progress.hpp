// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/observer.hpp"

#include <chrono>

namespace corticle::record
{

/// A line on the terminal that follows a run: t, step, steps per second, time left, area ratio, J range.
/// Silent when stderr is not a terminal or `quiet` is set.
class Progress final : public model::Observer
{
  public:
    Progress(const model::Simulation& simulation, double t_end, bool quiet);

    /// Redraws at most a few times a second.
    void on_step(const model::Simulation& simulation) override;
    // Both end the line, so that other output starts on a fresh one.
    void on_output(const model::OutputView& /*view*/) override { clear(); }
    void on_end(const model::Simulation& /*simulation*/, model::RunStatus /*status*/) override { clear(); }

  private:
    void clear() const;

    using Clock = std::chrono::steady_clock;
    bool shown_;
    double t_end_;
    double area_0_;
    Clock::time_point drawn_at_;
    double t_drawn_;
    std::int64_t steps_drawn_;
};

} // namespace corticle::record
