// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// Closest point of a surface.
struct SurfacePoint
{
    std::int32_t triangle = -1;          ///< -1 where there is none
    Vec3 position;                       ///< [mm]
    std::array<double, 3> barycentric{}; ///< weights of the triangle's corners, sum 1
    double squared_distance = 0.0;       ///< [mm²]
};

/// Bounding-volume tree over the triangles of a surface: closest points, crossings, winding numbers.
/// Keeps copies of the vertices and triangles. Queries are const and may run concurrently; ties go to the lowest
/// triangle index.
class SurfaceTree
{
  public:
    SurfaceTree(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

    /// Closest point of the surface.
    SurfacePoint closest(const Vec3& point) const;

    /// Closest point of the surface no farther than `reach` [mm]; its triangle is -1 where there is none.
    SurfacePoint closest_within(const Vec3& point, double reach) const;

    /// Unit normal at a surface point, interpolated from the angle-weighted vertex normals.
    Vec3 interpolated_normal(const SurfacePoint& point) const;

    /// Distance to the surface, negative inside [mm].
    double signed_distance(const Vec3& point) const;

    /// Distance of `point` to `foot`, its closest point, negative inside [mm]. The sign is that of the angle-weighted
    /// pseudonormal of the face, edge or vertex that carries the foot (Baerentzen & Aanaes 2005).
    double signed_distance(const Vec3& point, const SurfacePoint& foot) const;

    /// Does the segment from a to b meet a triangle? A segment in the plane of a triangle does not meet that one.
    bool segment_crosses(const Vec3& a, const Vec3& b) const;

    /// Winding number of a closed surface about a point off it: signed crossings of a ray in a fixed generic direction.
    /// 0 outside, 1 inside.
    int winding_number(const Vec3& point) const;

    const TriangleMesh& mesh() const { return mesh_; }

  private:
    struct Node
    {
        Vec3 low, high;
        std::int32_t left = -1; ///< child, or -1 for a leaf
        std::int32_t right = -1;
        std::int32_t first = 0; ///< leaf: range of order_
        std::int32_t count = 0;
    };

    void build();
    void split(std::int32_t node, std::span<const Vec3> centres);
    void compute_edge_normals();
    Vec3 pseudonormal(const SurfacePoint& foot) const;
    void improve(std::int32_t triangle, const Vec3& point, SurfacePoint& best) const;
    bool count_crossings(const Vec3& point, const Vec3& direction, int& crossings) const;

    TriangleMesh mesh_;
    std::vector<Vec3> normals_;                     ///< of the vertices
    std::vector<std::array<Vec3, 3>> edge_normals_; ///< sum of the two face normals; edge k is opposite to corner k
    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;
};

} // namespace corticle::geometry
