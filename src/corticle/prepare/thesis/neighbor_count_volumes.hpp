// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <span>
#include <vector>

namespace corticle::prepare
{

/// Volumes by neighbour counts (thesis eqs. 25-26): V_i = k / N_i, N_i the number of other particles within `radius` of
/// particle i, k such that they sum to the total volume [mm³]. Near the surface, where part of the ball about a
/// particle is empty, they are too large; `cells_of` is not.
/// @param positions     reference [mm]
/// @param radius        of the kernel [mm]
/// @param total_volume  of the body [mm³]
/// @throws InputError when the radius or the volume is not positive, or a particle has no neighbour
std::vector<double> neighbor_count_volumes(std::span<const Vec3> positions, double radius, double total_volume);

} // namespace corticle::prepare
