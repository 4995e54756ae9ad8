// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"

namespace corticle::metrics
{

/// Depth of each vertex below an outer surface, along the outside of the body [mm]: the shortest way from the outer
/// surface that does not pass through the body ("travel depth"; Coleman & Sharp 2006, J. Mol. Biol. 362; for brains
/// Giard et al. 2011, ISBI).
///
/// A vertex whose straight way to the closest point of the outer surface is free has exactly that distance. The others,
/// below an overhang or in a closed sulcus where the outside has no room, get the shortest way along the surface from
/// those (fast marching; Kimmel & Sethian 1998, PNAS 95). A part of the surface that no free vertex is joined to (the
/// wall of a cavity) gets the straight distance. On and beyond the outer surface the depth is 0.
///
/// @param outer  for instance the convex hull, or a closed surface around the gyri
std::vector<double> sulcal_depth(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                 const geometry::SurfaceTree& outer);

/// Shortest way along the surface from the seeds [mm], first order (fast marching on triangles; Kimmel & Sethian 1998).
/// @param start  known distance of the seeds [mm]; infinite for the other vertices, and in the result where no seed is
///               joined to them
std::vector<double> marched_distance(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                     std::vector<double> start);

} // namespace corticle::metrics
