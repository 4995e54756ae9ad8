// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// What belongs to each vertex of a surface: entries begin[v] to begin[v + 1] of `index`, ascending.
struct VertexLists
{
    std::vector<std::int32_t> begin; ///< vertices + 1 entries
    std::vector<std::int32_t> index;

    std::span<const std::int32_t> of(std::int32_t vertex) const
    {
        return std::span(index).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
    }
    std::int32_t size() const { return static_cast<std::int32_t>(begin.size()) - 1; }
};

/// Vertices that share an edge with each vertex.
VertexLists adjacent_vertices(std::size_t vertex_count, std::span<const Triangle> triangles);

/// Triangles that have each vertex as a corner.
VertexLists incident_triangles(std::size_t vertex_count, std::span<const Triangle> triangles);

} // namespace corticle::metrics
