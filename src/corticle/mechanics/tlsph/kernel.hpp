// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace corticle::tlsph
{

/// omega(r) = -W'(r) / r >= 0 [mm^-5]: 210 / (pi s^5) (1 - r/s)³, with the Wendland C2 kernel in three dimensions
/// W(r) = 21 / (2 pi s³) (1 - r/s)^4 (1 + 4 r/s) of support radius s (Wendland 1995), whose integral is 1. Its second
/// moment, the integral of omega X X^T, is I.
inline double pair_weight(double distance, double support)
{
    const double q = distance / support;
    if (q >= 1.0)
    {
        return 0.0;
    }
    const double p = 1.0 - q;
    const double s2 = support * support;
    return 210.0 / (std::numbers::pi * s2 * s2 * support) * p * p * p;
}

} // namespace corticle::tlsph
