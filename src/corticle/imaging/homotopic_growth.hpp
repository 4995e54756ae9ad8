// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"

#include <span>

namespace corticle::imaging
{

/// Grows a topological ball inside a mask from its deepest voxel, taking at each moment the voxel of highest value next
/// to it (then the deepest, then the first) that can be added without changing the topology. What it leaves of the
/// mask, cuts its handles. The mask is connected and has no cavity in Kuhn's triangulation. `depth` [mm or mm²] grows
/// with the distance to the outside.
Mask grow_ball(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, std::span<const float> depth);

/// The same from the outside: the whole grid but its outermost layer shrinks, voxel of lowest value (then farthest from
/// the mask, then first) first, to a topological ball that holds the mask. What it has beyond the mask, fills its
/// tunnels. `distance` grows with the distance to the mask.
Mask shrink_ball(const VoxelGrid& grid, const Mask& mask, std::span<const float> value,
                 std::span<const float> distance);

} // namespace corticle::imaging
