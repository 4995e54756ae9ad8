// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/even_out.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/delaunay_flips.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/mesh/sizes.hpp"

namespace corticle::geometry
{

namespace
{

constexpr int rounds = 6;
constexpr int sweeps_per_round = 5;
constexpr double range_edges = 1.8; ///< of the push, in edge lengths
constexpr double step = 0.06;
constexpr double longest_move = 0.1; ///< in edge lengths

/// Ends of the edges that leave each vertex: those of vertex v are end[begin[v]] … end[begin[v+1]-1].
struct Rings
{
    std::vector<std::int32_t> begin;
    std::vector<std::int32_t> end;
};

Rings rings_of(const TriangleMesh& mesh)
{
    Rings rings;
    rings.begin.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles)
    {
        for (const std::int32_t vertex : t)
        {
            ++rings.begin[vertex + 1];
        }
    }
    for (std::size_t v = 1; v < rings.begin.size(); ++v)
    {
        rings.begin[v] += rings.begin[v - 1];
    }
    rings.end.resize(3 * mesh.triangles.size());
    std::vector<std::int32_t> next(rings.begin.begin(), rings.begin.end() - 1);
    for (const Triangle& t : mesh.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            rings.end[next[t[k]]++] = t[(k + 1) % 3];
        }
    }
    return rings;
}

/// The move of a vertex that its neighbours ask for, along the surface [mm].
Vec3 tangential_push(const TriangleMesh& mesh, const Rings& rings, std::int64_t vertex, const Vec3& normal,
                     double edge_length)
{
    const double range = range_edges * edge_length;
    const Vec3& p = mesh.vertices[vertex];
    Vec3 push;
    for (std::int32_t k = rings.begin[vertex]; k < rings.begin[vertex + 1]; ++k)
    {
        const Vec3 d = p - mesh.vertices[rings.end[k]];
        const double r = norm(d);
        if (r > 0.0 && r < range)
        {
            const double gap = 1.0 - r / range;
            push += (gap * gap / r) * d;
        }
    }
    Vec3 move = (step * range) * push;
    move -= dot(move, normal) * normal;
    const double length = norm(move);
    const double longest = longest_move * edge_length;
    return length > longest ? (longest / length) * move : move;
}

/// Sweeps and flips that leave the vertices marked in `stays` alone, and the edges about them.
void push_and_flip(TriangleMesh& mesh, const SurfaceTree& surface, double edge_length, std::span<const char> stays)
{
    std::vector<Vec3> places(mesh.vertices.size());
    for (int round = 0; round < rounds; ++round)
    {
        flip_to_delaunay(mesh, stays);
        const Rings rings = rings_of(mesh);
        for (int sweep = 0; sweep < sweeps_per_round; ++sweep)
        {
            const std::vector<Vec3> normals = vertex_normals(mesh.vertices, mesh.triangles);
            parallel_for(static_cast<std::int64_t>(mesh.vertices.size()),
                         [&](std::int64_t v)
                         {
                             const Vec3 move = tangential_push(mesh, rings, v, normals[v], edge_length);
                             places[v] =
                                 stays[v] != 0 ? mesh.vertices[v] : surface.closest(mesh.vertices[v] + move).position;
                         });
            mesh.vertices.swap(places);
        }
    }
    flip_to_delaunay(mesh, stays);
}

/// Marks the vertices of triangles that cross, and those within `ring_count` edges of them.
void mark_crossings(const TriangleMesh& mesh, std::span<const std::pair<std::int32_t, std::int32_t>> crossings,
                    int ring_count, std::vector<char>& marks)
{
    for (const auto& pair : crossings)
    {
        for (const std::int32_t triangle : {pair.first, pair.second})
        {
            for (const std::int32_t vertex : mesh.triangles[triangle])
            {
                marks[vertex] = 1;
            }
        }
    }
    for (int ring = 0; ring < ring_count; ++ring)
    {
        const std::vector<char> before = marks;
        for (const Triangle& t : mesh.triangles)
        {
            const char any = before[t[0]] | before[t[1]] | before[t[2]];
            for (const std::int32_t vertex : t)
            {
                marks[vertex] |= any;
            }
        }
    }
}

} // namespace

void even_out(TriangleMesh& mesh, const SurfaceTree& surface, double edge_length)
{
    require_vertices(mesh);
    require_positive("edge length [mm]", edge_length);
    // Where the result folds (at the bottom of a fissure) the mesh is left as it was, and the rest done again.
    constexpr int most_tries = 3;
    std::vector<char> stays(mesh.vertices.size(), 0);
    for (int attempt = 0; attempt < most_tries; ++attempt)
    {
        TriangleMesh evened = mesh;
        push_and_flip(evened, surface, edge_length, stays);
        const auto crossings = self_intersections(evened);
        if (crossings.empty())
        {
            mesh = std::move(evened);
            return;
        }
        mark_crossings(evened, crossings, 1 + attempt, stays);
    }
}

} // namespace corticle::geometry
