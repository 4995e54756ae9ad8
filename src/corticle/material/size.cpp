// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/size.hpp"

namespace corticle::material
{

double brain_length(LengthLaw law, GestationalClock clock, double week)
{
    const double t = growth_time(clock, week);
    return law == LengthLaw::hyperbolic ? 59.0 / (1.0 - 0.55 * t) : (-0.067 * week + 7.16) * week - 66.05;
}

double ReferenceSize::scale(double t) const
{
    if (law == LengthLaw::none)
    {
        return 1.0;
    }
    return brain_length(law, clock, gestational_week(clock, t)) / brain_length(law, clock, start_week);
}

double ReferenceSize::scale_rate(double t) const
{
    if (law == LengthLaw::none)
    {
        return 0.0;
    }
    const double week = gestational_week(clock, t);
    const double length = brain_length(law, clock, week);
    const double lengthening = law == LengthLaw::hyperbolic
                                   ? 0.55 / 59.0 * length * length
                                   : (-2.0 * 0.067 * week + 7.16) / growth_time_rate(clock, week);
    return lengthening / brain_length(law, clock, start_week);
}

} // namespace corticle::material
