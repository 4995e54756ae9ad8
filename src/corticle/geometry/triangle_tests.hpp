// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"

// Tests against one triangle of a mesh. What depends on an edge is computed from its two ends in the order of their
// indices, so that the two triangles of an edge get the same bits: no ray slips between them, and closest points tie.

namespace corticle::geometry
{

/// Closest point of a triangle; a weight is exactly 0 where the point lies on the opposite edge.
SurfacePoint closest_point_of_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& point);

/// Does the segment from a to b meet the triangle? False for a segment in its plane.
bool segment_meets_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& a, const Vec3& b);

enum class RayHit
{
    none,
    outward,   ///< leaves through the front face
    inward,    ///< enters through the front face
    degenerate ///< meets an edge or a vertex, or starts on the triangle
};

/// Where the ray from `point` meets the triangle.
RayHit ray_hit(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& point, const Vec3& direction);

} // namespace corticle::geometry
