// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/geometry/surface_tree.hpp"

namespace corticle::cloud
{

/// `count` points spread over the inside of a closed surface, at least about half a spacing deep [mm]: one at random in
/// each cell of a cubic lattice, whose width is fitted to the count; fewer, at random, where the spacing is larger.
std::vector<Vec3> scatter_inside(const geometry::SurfaceTree& tree, std::int64_t count, const CloudOptions& options);

/// Spreads points by pair repulsion, as evenly as the grading says [mm]. The first ones are the vertices of the surface
/// and stay; the others keep their distance from the surface where the body is thick enough for it, and never leave it.
void relax_inside(const geometry::SurfaceTree& tree, const CloudOptions& options, std::vector<Vec3>& points);

/// Spacing about every point [mm].
std::vector<double> local_spacings(const geometry::SurfaceTree& tree, const CloudOptions& options,
                                   std::span<const Vec3> points);

/// One place at random in each cell of a cubic lattice of this width [mm], of those inside a closed surface.
std::vector<Vec3> places_inside(const geometry::SurfaceTree& tree, double width);

} // namespace corticle::cloud
