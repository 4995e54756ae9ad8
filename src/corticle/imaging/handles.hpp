// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/mask_report.hpp"
#include "corticle/imaging/voxel_grid.hpp"

#include <span>

namespace corticle::imaging
{

/// The mask {value > level}, made a topological ball.
struct BallMask
{
    Mask mask;
    std::vector<HandleChange> changes;
};

/// Removes the handles of a connected mask without cavities: a tunnel is filled where that changes less than half of
/// what cutting the handle does (voxels weighed by how far their values are from the level), else the handle is cut.
/// Places are in scanner millimetres.
BallMask remove_handles(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, float level);

} // namespace corticle::imaging
