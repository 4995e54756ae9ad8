// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <string>

namespace corticle::geometry
{

/// Refuses, with one InputError line that names `source`, a surface that is not finite, closed (number of boundary
/// edges), manifold, in one component, outward-oriented, free of self-intersections, and of positive volume. Vertices
/// at the same position are to be merged beforehand (merge_duplicates).
void require_valid_surface(const TriangleMesh& surface, const std::string& source);

/// Merges vertices at exactly the same position (STL has three a triangle) and drops unused ones and triangles that
/// collapse.
TriangleMesh merge_duplicates(const TriangleMesh& surface);

} // namespace corticle::geometry
