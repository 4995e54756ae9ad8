// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace corticle::contact
{

/// The share of its gap below which a pair never closes.
inline constexpr double least_share_of_gap = 0.02;

/// What a pair of parts at a distance d stores and how it repels. With l = least_share_of_gap · gap, the room left
/// r = d - l and the room at rest r_0 = gap - l,
///
///     E(d)  = f_0 [ r_0 ln(r_0 / r) - r_0 + r ]     for d < gap, else 0
///     -E'   = f_0 (r_0 / r - 1)                     the repulsion, without bound as d falls to l
///     E''   = f_0 r_0 / r²                          its stiffness
///
/// A logarithmic barrier as in Li et al., Incremental Potential Contact (2020), with a linear term in place of the
/// quadratic factor: its force begins at zero, and a narrow gap is as strong as a wide one.
struct Barrier
{
    double gap;            ///< distance below which it repels [mm]
    double force_constant; ///< f_0: the repulsion at half the room [mu_w mm²]

    double least_distance() const { return least_share_of_gap * gap; }
    double room_at_rest() const { return gap - least_distance(); }
    /// Never zero: what round-off may take of a distance must not turn a force around.
    double room(double d) const { return std::max(d - least_distance(), 1e-6 * gap); }

    double energy(double d) const
    {
        const double r = room(d);
        return force_constant * (room_at_rest() * std::log(room_at_rest() / r) - room_at_rest() + r);
    }
    double repulsion(double d) const { return force_constant * (room_at_rest() / room(d) - 1.0); }
    double stiffness(double d) const { return force_constant * room_at_rest() / (room(d) * room(d)); }
};

} // namespace corticle::contact
