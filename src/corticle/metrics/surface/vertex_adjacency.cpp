// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <algorithm>

namespace corticle::metrics
{

VertexLists incident_triangles(std::size_t vertex_count, std::span<const Triangle> triangles)
{
    VertexLists lists{std::vector<std::int32_t>(vertex_count + 1, 0), std::vector<std::int32_t>(3 * triangles.size())};
    for (const Triangle& t : triangles)
    {
        for (const std::int32_t v : t)
        {
            ++lists.begin[v + 1];
        }
    }
    for (std::size_t v = 0; v < vertex_count; ++v)
    {
        lists.begin[v + 1] += lists.begin[v];
    }
    std::vector<std::int32_t> next(lists.begin.begin(), lists.begin.end() - 1);
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
        for (const std::int32_t v : triangles[k])
        {
            lists.index[next[v]++] = static_cast<std::int32_t>(k);
        }
    }
    return lists;
}

VertexLists adjacent_vertices(std::size_t vertex_count, std::span<const Triangle> triangles)
{
    const VertexLists around = incident_triangles(vertex_count, triangles);
    VertexLists lists;
    lists.begin.reserve(vertex_count + 1);
    lists.begin.push_back(0);
    lists.index.reserve(3 * triangles.size());
    std::vector<std::int32_t> ring;
    for (std::int32_t v = 0; v < around.size(); ++v)
    {
        ring.clear();
        for (const std::int32_t k : around.of(v))
        {
            std::copy_if(triangles[k].begin(), triangles[k].end(), std::back_inserter(ring),
                         [v](std::int32_t other) { return other != v; });
        }
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        lists.index.insert(lists.index.end(), ring.begin(), ring.end());
        lists.begin.push_back(static_cast<std::int32_t>(lists.index.size()));
    }
    return lists;
}

} // namespace corticle::metrics
