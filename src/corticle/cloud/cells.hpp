// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::cloud
{

/// Voronoi cells of points, cut at a closed surface.
struct Cells
{
    std::vector<double> volumes; ///< [mm³]
    std::vector<Vec3> centroids; ///< [mm]
};

/// Lines along a spacing on which cells are measured.
inline constexpr double usual_lines_per_spacing = 6.0;

/// The cells, exact along lines parallel to z, summed over a lattice of such lines. Volumes are then scaled so that
/// they sum to the enclosed volume; all are positive.
/// @param spacing            of the points, where they are closest [mm]
/// @param lines_per_spacing  along each side of the lattice
/// @param largest_spacing    of the points, where they are sparsest [mm]; 0: the same
Cells cells_of(const TriangleMesh& surface, std::span<const Vec3> points, double spacing,
               double lines_per_spacing = usual_lines_per_spacing, double largest_spacing = 0.0);

} // namespace corticle::cloud
