// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"

namespace corticle::metrics
{

/// Local gyrification index of each vertex [-]: area of the part of the surface whose closest point of the outer
/// surface lies in a ball about that of the vertex, over the area of the outer surface in the ball. So the whole depth
/// of a sulcus counts, as in Schaer et al. 2008 (IEEE Trans. Med. Imaging 27), who take the outer surface from a
/// morphological closing and find the matching part by geodesics from the rim of the patch.
/// @param outer   for instance the convex hull
/// @param radius  of the ball [mm]; Schaer takes 25 for adult brains
/// @throws InputError when the radius is not positive
std::vector<double> local_gyrification(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                       const geometry::SurfaceTree& outer, double radius);

} // namespace corticle::metrics
