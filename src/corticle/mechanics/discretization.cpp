// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/discretization.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::mechanics
{

void join(InternalResponse& total, const InternalResponse& part)
{
    total.elastic_energy += part.elastic_energy;
    total.zero_mode_energy += part.zero_mode_energy;
    total.growth_power += part.growth_power;
    total.released += part.released;
    total.stiffest_rate = std::max(total.stiffest_rate, part.stiffest_rate);
    total.barrier_count += part.barrier_count;
    total.extrapolated_count += part.extrapolated_count;
    total.inverted_count += part.inverted_count;
    if (part.smallest_J < total.smallest_J)
    {
        total.smallest_J = part.smallest_J;
        total.smallest_J_at = part.smallest_J_at;
    }
    total.invalid_at = total.invalid_at < 0 ? part.invalid_at : total.invalid_at;
}

std::string describe_point(const Vec3& x, const Vec3& X, double depth, const Mat3& F)
{
    return fmt::format("position ({:.5g}, {:.5g}, {:.5g}) mm, reference ({:.5g}, {:.5g}, {:.5g}) mm, depth {:.4g} mm, "
                       "J = {:.4g}, F = [[{:.4g}, {:.4g}, {:.4g}], [{:.4g}, {:.4g}, {:.4g}], [{:.4g}, {:.4g}, "
                       "{:.4g}]]",
                       x.x, x.y, x.z, X.x, X.y, X.z, depth, determinant(F), F(0, 0), F(0, 1), F(0, 2), F(1, 0), F(1, 1),
                       F(1, 2), F(2, 0), F(2, 1), F(2, 2));
}

} // namespace corticle::mechanics
