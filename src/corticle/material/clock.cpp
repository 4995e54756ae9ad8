// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/clock.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::material
{

namespace
{

double wang_time(double week)
{
    return 0.987 * std::exp(-std::exp(-0.134 * (week - 29.433)));
}

double cubic_time(double week)
{
    return ((6.926e-5 * week - 0.00665) * week + 0.250) * week - 3.0189;
}

double time_at(GestationalClock clock, double week)
{
    return clock == GestationalClock::wang ? wang_time(week) : cubic_time(week);
}

const char* name_of(GestationalClock clock)
{
    return clock == GestationalClock::wang ? "wang" : "cubic";
}

void require_clock(GestationalClock clock)
{
    if (clock == GestationalClock::none)
    {
        throw InputError("time.clock: got \"none\", expected a clock, \"wang\" or \"cubic\", that turns t into weeks");
    }
}

} // namespace

WeekRange week_range(GestationalClock clock)
{
    switch (clock)
    {
    case GestationalClock::wang:
        return {16.0, 60.0};
    case GestationalClock::cubic:
        return {22.0, 44.0};
    default:
        return {0.0, 0.0};
    }
}

double growth_time(GestationalClock clock, double week)
{
    require_clock(clock);
    const auto [first, last] = week_range(clock);
    if (!(week >= first && week <= last))
    {
        throw InputError(fmt::format("time.clock = \"{}\": got {:g} weeks, expected {:g} to {:g}", name_of(clock), week,
                                     first, last));
    }
    return time_at(clock, week);
}

double growth_time_rate(GestationalClock clock, double week)
{
    const double t = growth_time(clock, week);
    return clock == GestationalClock::wang ? 0.134 * std::exp(-0.134 * (week - 29.433)) * t
                                           : (3.0 * 6.926e-5 * week - 2.0 * 0.00665) * week + 0.250;
}

double gestational_week(GestationalClock clock, double t)
{
    require_clock(clock);
    auto [low, high] = week_range(clock);
    const double earliest = time_at(clock, low);
    const double latest = time_at(clock, high);
    if (!(t >= earliest && t <= latest))
    {
        throw InputError(
            fmt::format("time.clock = \"{}\": got t = {:g}, expected {:.4g} to {:.4g} ({:g} to {:g} weeks)",
                        name_of(clock), t, earliest, latest, low, high));
    }
    for (;;)
    {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high))
        {
            return t - time_at(clock, low) <= time_at(clock, high) - t ? low : high;
        }
        (time_at(clock, middle) <= t ? low : high) = middle;
    }
}

} // namespace corticle::material
