// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/thinning.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace corticle::report
{

namespace
{

/// Neighbours of each vertex, one after the other.
struct Neighbors
{
    std::vector<std::size_t> first;
    std::vector<std::int32_t> vertex;
};

Neighbors neighbors_of(std::span<const Triangle> triangles, std::size_t vertex_count)
{
    Neighbors neighbors{std::vector<std::size_t>(vertex_count + 1), {}};
    for (const Triangle& triangle : triangles)
    {
        for (const std::int32_t v : triangle)
        {
            ++neighbors.first[static_cast<std::size_t>(v) + 1];
        }
    }
    std::partial_sum(neighbors.first.begin(), neighbors.first.end(), neighbors.first.begin());
    neighbors.vertex.resize(neighbors.first.back());
    std::vector<std::size_t> next(neighbors.first.begin(), neighbors.first.end() - 1);
    for (const Triangle& triangle : triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            // Of a closed surface each neighbour of a vertex follows it in one triangle.
            neighbors.vertex[next[static_cast<std::size_t>(triangle[k])]++] = triangle[(k + 1) % 3];
        }
    }
    return neighbors;
}

/// For each vertex the kept one that is nearest in edges; ties go to the one reached first.
std::vector<std::int32_t> regions(const Neighbors& neighbors, std::span<const std::int32_t> kept)
{
    std::vector<std::int32_t> region(neighbors.first.size() - 1, -1);
    std::vector<std::int32_t> queue(kept.begin(), kept.end());
    for (std::size_t k = 0; k < kept.size(); ++k)
    {
        region[static_cast<std::size_t>(kept[k])] = static_cast<std::int32_t>(k);
    }
    for (std::size_t at = 0; at < queue.size(); ++at)
    {
        const auto v = static_cast<std::size_t>(queue[at]);
        for (std::size_t n = neighbors.first[v]; n < neighbors.first[v + 1]; ++n)
        {
            std::int32_t& other = region[static_cast<std::size_t>(neighbors.vertex[n])];
            if (other < 0)
            {
                other = region[v];
                queue.push_back(neighbors.vertex[n]);
            }
        }
    }
    return region;
}

} // namespace

ThinSurface thin_surface(std::span<const Triangle> triangles, std::size_t vertex_count, std::size_t count)
{
    ThinSurface thin;
    if (count >= vertex_count)
    {
        thin.kept.resize(vertex_count);
        std::iota(thin.kept.begin(), thin.kept.end(), 0);
        thin.triangles.assign(triangles.begin(), triangles.end());
        return thin;
    }
    for (const std::size_t v : spread(vertex_count, std::max<std::size_t>(count, 4)))
    {
        thin.kept.push_back(static_cast<std::int32_t>(v));
    }
    const std::vector<std::int32_t> region = regions(neighbors_of(triangles, vertex_count), thin.kept);
    std::set<std::array<std::int32_t, 3>> seen;
    for (const Triangle& triangle : triangles)
    {
        Triangle between{};
        for (std::size_t k = 0; k < 3; ++k)
        {
            between[k] = region[static_cast<std::size_t>(triangle[k])];
        }
        std::array<std::int32_t, 3> sorted{between[0], between[1], between[2]};
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] >= 0 && sorted[0] != sorted[1] && sorted[1] != sorted[2] && seen.insert(sorted).second)
        {
            thin.triangles.push_back(between);
        }
    }
    return thin;
}

std::vector<std::size_t> spread(std::size_t all, std::size_t count)
{
    std::vector<std::size_t> chosen;
    const std::size_t wanted = std::min(all, std::max<std::size_t>(count, 2));
    for (std::size_t k = 0; k < wanted; ++k)
    {
        chosen.push_back(wanted == 1 ? all - 1 : (k * (all - 1) + (wanted - 1) / 2) / (wanted - 1));
    }
    return chosen;
}

} // namespace corticle::report
