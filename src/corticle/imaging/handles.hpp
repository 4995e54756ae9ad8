// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/mask_report.hpp"
#include "corticle/imaging/voxel_grid.hpp"

#include <span>

namespace corticle
{

/// The mask {value > level}, made a topological ball.
struct BallMask
{
    Mask mask;
    std::vector<HandleChange> changes;
};

/// Removes the handles of a connected mask without cavities: tunnels are filled where that changes less than cutting
/// the handle does (weighed by how far the values are from the level), else handles are cut. Places are in the frame of
/// the grid.
BallMask remove_handles(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, float level);

} // namespace corticle
