// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace corticle
{

/// Adds the wall time from its making to its end to a sum [s].
class Stopwatch
{
  public:
    explicit Stopwatch(double& sum) : sum_(sum), start_(Clock::now()) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_;
    Clock::time_point start_;
};

} // namespace corticle
