// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/contact/box_tiles.hpp"
#include "corticle/mechanics/contact/surface_share.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace corticle::contact
{

/// Vertices at the ends of an edge, the lower first.
using Edge = std::array<std::int32_t, 2>;

/// Every edge of a triangulation once, in lexicographic order.
std::vector<Edge> unique_edges(std::span<const Triangle> triangles);

/// A vertex and a triangle of which it is not a corner.
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

/// Those who repel the other part if the pair is their closest: the vertex of a triangle, or both edges.
inline std::array<std::int32_t, 1> owners_of(const VertexTriangle& pair)
{
    return {pair.vertex};
}
inline std::array<std::int32_t, 2> owners_of(const EdgeEdge& pair)
{
    return {pair.first, pair.second};
}

/// The vertices of both parts of a pair.
inline std::array<std::int32_t, 4> vertices_of(const VertexTriangle& pair, const Triangle* triangles)
{
    const Triangle& corner = triangles[pair.triangle];
    return {pair.vertex, corner[0], corner[1], corner[2]};
}
inline std::array<std::int32_t, 4> vertices_of(const EdgeEdge& pair, const Edge* edges)
{
    const Edge& a = edges[pair.first];
    const Edge& b = edges[pair.second];
    return {a[0], a[1], b[0], b[1]};
}

/// The closest points of a pair.
struct ClosestPoints
{
    Vec3 between;                 ///< from that of the second part to that of the first [mm]
    std::array<double, 4> weight; ///< of the four vertices: positive in the first part, negative in the second
};

/// No vertex is one of a wall, see SurfaceParts.
inline constexpr std::int32_t no_wall = std::numeric_limits<std::int32_t>::max();

/// All pairs of a surface that lie within a distance of each other. Two pairs stand in the same order in all lists that
/// hold both.
struct Candidates
{
    std::vector<VertexTriangle> vertex_triangle;
    std::vector<EdgeEdge> edge_edge;
};

/// The vertices, edges and triangles of a closed surface that moves, each numbered so that neighbours follow each
/// other.
class SurfaceParts
{
  public:
    /// @param rest  positions of the vertices that the numbers are given by [mm]
    /// @param wall  first vertex of a wall around the surface, a closed surface of its own behind all others: pairs
    ///              within it count for nothing. Its parts are numbered after all others, so these keep their numbers.
    SurfaceParts(std::span<const Triangle> triangles, std::span<const Vec3> rest, std::int32_t wall = no_wall);

    std::span<const Triangle> triangles() const { return triangles_; }
    std::span<const Edge> edges() const { return edges_; }
    std::array<std::int32_t, 4> vertices_of(const VertexTriangle& pair) const
    {
        return contact::vertices_of(pair, triangles_.data());
    }
    std::array<std::int32_t, 4> vertices_of(const EdgeEdge& pair) const
    {
        return contact::vertices_of(pair, edges_.data());
    }

    /// Sets `found` to the pairs closer than `range` plus the reach of both their parts, that of an edge or a triangle
    /// being the largest of its vertices; for a share of the vertices, to all pairs of those owners that have one with
    /// a vertex of it. The result depends on the positions and the reach alone.
    /// @param x      positions of the vertices [mm]
    /// @param reach  of every vertex [mm]
    void find_candidates(std::span<const Vec3> x, double range, std::span<const double> reach,
                         const SurfaceShare& share, Candidates& found);

    /// Distances at positions x, into the pairs [mm].
    void measure(std::span<const Vec3> x, std::span<VertexTriangle> pairs) const;
    void measure(std::span<const Vec3> x, std::span<EdgeEdge> pairs) const;

    /// Closest points at positions x, of every pair.
    void locate(std::span<const Vec3> x, std::span<const VertexTriangle> pairs, std::span<ClosestPoints> points) const;
    void locate(std::span<const Vec3> x, std::span<const EdgeEdge> pairs, std::span<ClosestPoints> points) const;

  private:
    /// What is searched for, or in.
    struct Searched
    {
        BoxTiles boxes;            ///< around each part, wider by its reach and half the range
        std::vector<double> reach; ///< of each part [mm]
    };
    template <class Part>
    static void enclose(std::span<const Part> parts, std::span<const Vec3> x, double range,
                        std::span<const double> reach, Searched& searched);

    void search_about(const SurfaceShare& share, std::span<const Vec3> x, double cell);
    template <class Pair>
    void keep_owners(const SurfaceShare& share, std::size_t owners, std::vector<Pair>& pairs) const;

    std::int32_t wall_;
    std::vector<std::array<std::int32_t, 1>> vertices_; ///< every vertex once
    std::vector<Triangle> triangles_;
    std::vector<Edge> edges_;
    Searched searched_vertices_;
    Searched searched_triangles_;
    Searched searched_edges_;
};

} // namespace corticle::contact
