// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::cloud
{

/// Volumes of the Voronoi cells of points, cut at a closed surface [mm³]: exact along lines parallel to z, summed over
/// a lattice of such lines, then scaled so that they sum to the enclosed volume. All are positive.
/// @param spacing            of the points [mm]
/// @param lines_per_spacing  along each side of the lattice
std::vector<double> cell_volumes(const TriangleMesh& surface, std::span<const Vec3> points, double spacing,
                                 double lines_per_spacing = 6.0);

} // namespace corticle::cloud
