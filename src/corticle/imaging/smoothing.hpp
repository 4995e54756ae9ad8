// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"

namespace corticle::imaging
{

/// Gaussian of standard deviation `sigma` [mm] along the three edges of the voxels, cut at four of it; values beyond
/// the grid are 0, and so is the result in the outermost layer.
void smooth_gaussian(const VoxelGrid& grid, double sigma, std::vector<float>& values);

} // namespace corticle::imaging
