// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"

namespace corticle::imaging
{

/// Squared distance of every voxel centre to the nearest centre of a voxel whose mask equals `value` [mm²]; a very
/// large number where there is none. Exact for voxels with right angles, by lower envelopes of parabolas along each
/// axis (Felzenszwalb & Huttenlocher 2012, section 2).
std::vector<float> squared_distance_to(const VoxelGrid& grid, const Mask& mask, std::uint8_t value);

} // namespace corticle::imaging
