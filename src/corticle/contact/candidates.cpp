// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/candidates.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/contact/box_grid.hpp"
#include "corticle/geometry/distance.hpp"

namespace corticle
{

namespace
{

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

/// What is searched for: edges or triangles, each with its box and its reach.
struct Parts
{
    std::vector<Box> boxes;    ///< wider than the part by its reach and the margin
    std::vector<double> reach; ///< [mm]
};

template <class Corners>
Parts parts_of(std::span<const Vec3> x, std::span<const double> reach, std::span<const Corners> items, double margin)
{
    Parts parts{std::vector<Box>(items.size()), std::vector<double>(items.size())};
    parallel_for(std::ssize(items),
                 [&](std::int64_t k)
                 {
                     const Corners& corners = items[static_cast<std::size_t>(k)];
                     Box box{at(x, corners[0]), at(x, corners[0])};
                     double largest = 0.0;
                     for (const std::int32_t corner : corners)
                     {
                         const Vec3 p = at(x, corner);
                         box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
                         box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
                         largest = std::max(largest, reach[static_cast<std::size_t>(corner)]);
                     }
                     const double wide = margin + largest;
                     parts.boxes[k] = {box.low - Vec3{wide, wide, wide}, box.high + Vec3{wide, wide, wide}};
                     parts.reach[k] = largest;
                 });
    return parts;
}

/// Runs `search(begin, end, found)` over blocks concurrently and joins what they found in order.
template <class Pair, class Search>
std::vector<Pair> collect(std::int64_t count, Search&& search)
{
    return parallel_reduce(
        count, std::vector<Pair>{},
        [&](std::int64_t begin, std::int64_t end)
        {
            std::vector<Pair> found;
            search(begin, end, found);
            return found;
        },
        [](std::vector<Pair>& all, const std::vector<Pair>& part) { all.insert(all.end(), part.begin(), part.end()); });
}

std::vector<VertexTriangle> close_vertex_triangles(std::span<const Vec3> x, std::span<const Triangle> triangles,
                                                   double range, std::span<const double> reach, double cell)
{
    const auto parts = parts_of(x, reach, triangles, range);
    const BoxGrid grid(parts.boxes, cell);
    return collect<VertexTriangle>(
        std::ssize(x),
        [&](std::int64_t begin, std::int64_t end, std::vector<VertexTriangle>& found)
        {
            std::vector<std::int32_t> overlapping;
            for (std::int64_t v = begin; v < end; ++v)
            {
                const auto vertex = static_cast<std::int32_t>(v);
                const std::size_t first = found.size();
                const Vec3 p = at(x, vertex);
                const double wide = reach[static_cast<std::size_t>(v)];
                grid.query({p - Vec3{wide, wide, wide}, p + Vec3{wide, wide, wide}}, -1, overlapping);
                for (const std::int32_t triangle : overlapping)
                {
                    const Triangle& corner = triangles[static_cast<std::size_t>(triangle)];
                    if (std::find(corner.begin(), corner.end(), vertex) != corner.end())
                    {
                        continue;
                    }
                    const Vec3 a = at(x, corner[0]);
                    const Vec3 b = at(x, corner[1]);
                    const Vec3 c = at(x, corner[2]);
                    const auto weight = closest_on_triangle(p, a, b, c);
                    const double squared = squared_norm(p - (weight[0] * a + weight[1] * b + weight[2] * c));
                    const double within = range + wide + parts.reach[static_cast<std::size_t>(triangle)];
                    if (squared < within * within)
                    {
                        found.push_back({vertex, triangle, std::sqrt(squared)});
                    }
                }
                std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                          [](const VertexTriangle& a, const VertexTriangle& b) { return a.triangle < b.triangle; });
            }
        });
}

std::vector<EdgeEdge> close_edge_edges(std::span<const Vec3> x, std::span<const Edge> edges, double range,
                                       std::span<const double> reach, double cell)
{
    const auto parts = parts_of(x, reach, edges, 0.5 * range);
    const BoxGrid grid(parts.boxes, cell);
    return collect<EdgeEdge>(std::ssize(edges),
                             [&](std::int64_t begin, std::int64_t end, std::vector<EdgeEdge>& found)
                             {
                                 std::vector<std::int32_t> overlapping;
                                 for (std::int64_t k = begin; k < end; ++k)
                                 {
                                     const auto first = static_cast<std::int32_t>(k);
                                     const Edge e = edges[static_cast<std::size_t>(k)];
                                     const std::size_t begin_of_edge = found.size();
                                     grid.query(parts.boxes[static_cast<std::size_t>(k)], first, overlapping);
                                     for (const std::int32_t second : overlapping)
                                     {
                                         const Edge o = edges[static_cast<std::size_t>(second)];
                                         if (e[0] == o[0] || e[0] == o[1] || e[1] == o[0] || e[1] == o[1])
                                         {
                                             continue;
                                         }
                                         const Vec3 a = at(x, e[0]);
                                         const Vec3 b = at(x, e[1]);
                                         const Vec3 c = at(x, o[0]);
                                         const Vec3 d = at(x, o[1]);
                                         const auto [s, t] = closest_of_segments(a, b, c, d);
                                         const double squared = squared_norm(a + s * (b - a) - c - t * (d - c));
                                         const double within = range + parts.reach[static_cast<std::size_t>(k)] +
                                                               parts.reach[static_cast<std::size_t>(second)];
                                         if (squared < within * within)
                                         {
                                             found.push_back({first, second, std::sqrt(squared)});
                                         }
                                     }
                                     std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin_of_edge), found.end(),
                                               [](const EdgeEdge& a, const EdgeEdge& b)
                                               { return a.second < b.second; });
                                 }
                             });
}

} // namespace

std::vector<Edge> unique_edges(std::span<const Triangle> triangles)
{
    std::vector<Edge> edges;
    edges.reserve(triangles.size() * 3);
    for (const Triangle& corner : triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::int32_t a = corner[k];
            const std::int32_t b = corner[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

Candidates find_candidates(std::span<const Vec3> x, std::span<const Triangle> triangles, std::span<const Edge> edges,
                           double range, std::span<const double> reach)
{
    const double lengths = parallel_sum(std::ssize(edges),
                                        [&](std::int64_t k)
                                        {
                                            const Edge& e = edges[static_cast<std::size_t>(k)];
                                            return norm(at(x, e[0]) - at(x, e[1]));
                                        });
    const double cell = lengths / static_cast<double>(edges.size()) + range;
    return {close_vertex_triangles(x, triangles, range, reach, cell), close_edge_edges(x, edges, range, reach, cell)};
}

} // namespace corticle
