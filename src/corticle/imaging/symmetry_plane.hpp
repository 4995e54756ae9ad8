// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"

namespace corticle::imaging
{

/// The points x with dot(normal, x) = offset, scanner frame [mm].
struct Plane
{
    Vec3 normal{1, 0, 0}; ///< unit
    double offset = 0.0;
};

/// The plane of best mirror symmetry of a mask near its mid-sagittal one: that in which its mirror image overlaps it
/// most, searched from x = its centroid by shifts and tilts that halve down to 0.05 mm and 0.05 degrees. The normal
/// points to the right.
Plane midsagittal_plane(const VoxelGrid& grid, const Mask& mask);

} // namespace corticle::imaging
