// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::material
{

/// How growth time t and gestational age in weeks go together.
enum class GestationalClock
{
    none, ///< t is only a number
    wang, ///< t = 0.987 exp(-exp(-0.134 (w - 29.433))): Wang et al. 2021; thesis eq. 17, which lost two minus signs
    cubic ///< t = 6.926e-5 w³ - 0.00665 w² + 0.250 w - 3.0189: Tallinen et al. 2016; 0 at 22 weeks, 1 at 44
};

/// Weeks in which a clock may be read.
struct WeekRange
{
    double first; ///< [weeks]
    double last;  ///< [weeks]
};
/// 16 to 60 weeks for "wang" (before, no cortex folds; after, t gains less than 2 % more), 22 to 44 for "cubic".
/// Empty (0, 0) for no clock.
WeekRange week_range(GestationalClock clock);

/// t at a gestational age [weeks]. Increases strictly.
/// @throws InputError without a clock and beyond its range
double growth_time(GestationalClock clock, double week);

/// dt/dw at a gestational age [1/week]. @throws InputError as growth_time
double growth_time_rate(GestationalClock clock, double week);

/// Gestational age [weeks] at t, the inverse of growth_time, by bisection down to neighbouring numbers.
/// @throws InputError without a clock and for a t that the clock does not reach in its range
double gestational_week(GestationalClock clock, double t);

} // namespace corticle::material
