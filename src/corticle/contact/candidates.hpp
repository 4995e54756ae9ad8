// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Vertices at the ends of an edge, the lower first.
using Edge = std::array<std::int32_t, 2>;

/// Every edge of a triangulation once, in lexicographic order.
std::vector<Edge> unique_edges(std::span<const Triangle> triangles);

/// A vertex and a triangle it is no corner of.
struct VertexTriangle
{
    std::int32_t vertex;
    std::int32_t triangle;
    double distance; ///< where it was found [mm]
};

/// Two edges without a common vertex, the lower index first.
struct EdgeEdge
{
    std::int32_t first;
    std::int32_t second;
    double distance; ///< where it was found [mm]
};

/// All pairs of a surface that lie within a distance of each other.
struct Candidates
{
    std::vector<VertexTriangle> vertex_triangle; ///< in ascending order of vertex, then triangle
    std::vector<EdgeEdge> edge_edge;             ///< in ascending order of first, then second
};

/// Finds the pairs closer than `range` plus the reach of both their parts, that of an edge or a triangle being the
/// largest of its vertices. The result depends on the positions and the reach alone.
/// @param reach  of every vertex [mm]
Candidates find_candidates(std::span<const Vec3> x, std::span<const Triangle> triangles, std::span<const Edge> edges,
                           double range, std::span<const double> reach);

} // namespace corticle
