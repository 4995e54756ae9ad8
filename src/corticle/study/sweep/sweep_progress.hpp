// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_folder.hpp"

#include <chrono>

namespace corticle::sweep
{

struct SweepJob;

/// A line for each run that ends, on standard output, with its warnings on standard error, and a line on the terminal
/// that follows all runs: done of total, running, failed, time left. Silent when `quiet` is set; the line is not drawn
/// where stderr is not a terminal.
class SweepProgress
{
  public:
    /// @param done  runs finished before
    SweepProgress(std::span<const SweepJob> jobs, std::size_t done, bool quiet);
    void finish(std::size_t job, const RunState& state);
    /// Redraws at most a few times a second; `running` are jobs.
    void update(std::span<const std::size_t> running);

  private:
    using Clock = std::chrono::steady_clock;

    std::span<const SweepJob> jobs_;
    std::size_t done_;
    std::size_t total_;
    std::size_t failed_ = 0;
    bool quiet_;
    bool shown_;
    double cost_ = 0.0;      ///< of all jobs
    double done_cost_ = 0.0; ///< of those that ended
    Clock::time_point start_;
    Clock::time_point drawn_at_;
};

} // namespace corticle::sweep
