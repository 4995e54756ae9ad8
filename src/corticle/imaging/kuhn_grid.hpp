// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"

namespace corticle::imaging
{

// The voxel centres are the vertices of Kuhn's (Freudenthal's) triangulation: each cell between eight of them is cut
// into six tetrahedra along the paths from its lowest to its highest corner. A voxel has 14 neighbours, one along each
// edge: steps of 0 or 1 along each axis, or of 0 or -1. They form a triangulated sphere, its link. A set of voxels
// stands for the tetrahedra, triangles and edges between them: inside and outside then obey the same rule, no
// configuration is ambiguous, and the isosurface cut through the tetrahedra is a closed manifold of that topology.

/// Step number k of 14: 0 to 6 upward, bits of k + 1 along x, y, z; 7 to 13 the opposite of k - 7.
inline constexpr int kuhn_neighbors = 14;

/// Differences of the voxel index to the 14 neighbours.
std::array<std::int64_t, kuhn_neighbors> kuhn_offsets(const VoxelGrid& grid);

/// Can a voxel change sides without changing the topology? `inside` has a bit for each of its 14 neighbours. True when
/// those inside are connected within the link, those outside are, and there are some of both.
bool is_simple(unsigned inside);

/// Components less handles plus cavities of a mask (vertices - edges + triangles - tetrahedra).
std::int64_t euler_characteristic(const VoxelGrid& grid, const Mask& mask);

/// Numbers the components, from 1 in the order of their first voxels, of the voxels with mask == `value` (others get
/// 0), and counts them; sizes[0] is unused.
struct Components
{
    std::vector<std::int32_t> number;
    std::vector<std::int64_t> sizes;
};
Components kuhn_components(const VoxelGrid& grid, const Mask& mask, std::uint8_t value);

} // namespace corticle::imaging
