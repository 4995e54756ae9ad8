// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace corticle::dynamics
{

/// A step that is about to be tried.
struct StepPlan
{
    double t_before;           ///< growth time at its beginning [-]
    double t;                  ///< growth time at its end [-]
    double dt;                 ///< its length in time
    std::int64_t halvings = 0; ///< how often it was taken back before
};

/// A step no farther than growth time t_stop, which it reaches exactly where little is left.
/// @param t           growth time now [-]
/// @param stable      longest step in time, rejections included
/// @param rate        of loading, dt/dtime in units of 1/total_time
/// @param total_time  T, time of t = 0..1
inline StepPlan plan_step(double t, double t_stop, double stable, double rate, double total_time)
{
    constexpr double rounding = 1e-12; // of t: a remainder this small is no step of its own
    const double full = stable * rate / total_time;
    const double end = t_stop - t <= full * (1.0 + rounding) ? t_stop : t + full;
    return {t, end, (end - t) * total_time / rate};
}

} // namespace corticle::dynamics
