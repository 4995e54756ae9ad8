// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <span>

namespace corticle::imaging
{

/// The surface value = level of the values interpolated linearly in the tetrahedra of Kuhn's triangulation of the voxel
/// centres (kuhn_grid.hpp), in the frame of the grid [mm]; closed, manifold and outward whatever the frame's
/// handedness. Values in the outermost layer are not above the level. Crossings keep `clearance` (a share of the edge)
/// from its ends, so that no triangle degenerates. (Marching tetrahedra: Doi & Koide 1991; no ambiguous cases.)
TriangleMesh marching_tetrahedra(const VoxelGrid& grid, std::span<const float> values, float level,
                                 double clearance = 0.0);

} // namespace corticle::imaging
