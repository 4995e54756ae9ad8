// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <utility>

namespace corticle::geometry
{

/// Pairs of triangles that cross, or overlap beyond a shared vertex or edge, of a closed manifold surface, in
/// ascending order (CGAL, exact predicates).
std::vector<std::pair<std::int32_t, std::int32_t>> self_intersections(const TriangleMesh& surface);

/// Number of triangles that cross or overlap another one.
std::int64_t intersecting_triangles(const TriangleMesh& surface);

} // namespace corticle::geometry
