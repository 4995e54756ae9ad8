// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/candidates.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/contact/box_tiles.hpp"
#include "corticle/mechanics/contact/cell_marks.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

namespace corticle::contact
{

namespace
{

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

/// Sets `found` to the pairs of parts, one of each kind, that are closer than range plus the reach of both.
/// @param pair_of  pair_of(first, second) makes a pair of two parts
/// @param wanted   wanted(pair) says whether it counts
/// @param measure  measure(pairs) sets the distances of several
template <class Pair, class Searched, class PairOf, class Wanted, class Measure>
void find_pairs(const Searched& firsts, const Searched& seconds, double range, std::vector<Pair>& found,
                PairOf&& pair_of, Wanted&& wanted, Measure&& measure)
{
    constexpr std::int64_t tiles_at_a_time = 8;
    parallel_list(
        firsts.boxes.tile_count(), found,
        [&](std::int64_t begin, std::int64_t end, std::vector<Pair>& pairs)
        {
            std::vector<BoxPair> overlapping;
            std::vector<double> within;
            std::size_t count = 0;
            for (std::int64_t tile = begin; tile < end; ++tile)
            {
                firsts.boxes.find_overlaps(static_cast<std::int32_t>(tile), seconds.boxes, overlapping);
                pairs.resize(count + overlapping.size());
                within.resize(count + overlapping.size());
                for (const auto& [first, second] : overlapping)
                {
                    pairs[count] = pair_of(first, second);
                    within[count] = range + firsts.reach[static_cast<std::size_t>(first)] +
                                    seconds.reach[static_cast<std::size_t>(second)];
                    count += wanted(pairs[count]) ? 1 : 0;
                }
            }
            pairs.resize(count);
            measure(pairs);
            std::size_t kept = 0;
            for (std::size_t k = 0; k < count; ++k)
            {
                pairs[kept] = pairs[k];
                kept += pairs[k].distance < within[k] ? 1 : 0;
            }
            pairs.resize(kept);
        },
        tiles_at_a_time);
}

/// Appends the parts of the wall, or all others, in the order of a curve through their middles.
template <class Part>
void append_in_order(std::span<const Part> all, std::span<const Vec3> x, std::int32_t wall, bool of_wall,
                     std::vector<Part>& ordered)
{
    std::vector<Part> parts;
    std::ranges::copy_if(all, std::back_inserter(parts),
                         [&](const Part& part) { return (part[0] >= wall) == of_wall; });
    std::vector<Vec3> middles;
    middles.reserve(parts.size());
    for (const Part& part : parts)
    {
        Vec3 sum;
        for (const std::int32_t vertex : part)
        {
            sum += at(x, vertex);
        }
        middles.push_back(sum / static_cast<double>(part.size()));
    }
    for (const std::int32_t k : hilbert_order(middles))
    {
        ordered.push_back(parts[static_cast<std::size_t>(k)]);
    }
}

template <class Part>
std::vector<Part> in_order(std::span<const Part> parts, std::span<const Vec3> x, std::int32_t wall)
{
    std::vector<Part> ordered;
    ordered.reserve(parts.size());
    append_in_order(parts, x, wall, false, ordered);
    if (wall != no_wall)
    {
        append_in_order(parts, x, wall, true, ordered);
    }
    return ordered;
}

std::vector<std::array<std::int32_t, 1>> every_vertex(std::size_t count)
{
    std::vector<std::array<std::int32_t, 1>> vertices;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(count); ++k)
    {
        vertices.push_back({k});
    }
    return vertices;
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

SurfaceParts::SurfaceParts(std::span<const Triangle> triangles, std::span<const Vec3> rest, std::int32_t wall)
    : wall_(wall),
      vertices_(in_order(std::span<const std::array<std::int32_t, 1>>(every_vertex(rest.size())), rest, wall)),
      triangles_(in_order(triangles, rest, wall)),
      edges_(in_order(std::span<const Edge>(unique_edges(triangles)), rest, wall))
{
}

template <class Part>
void SurfaceParts::enclose(std::span<const Part> parts, std::span<const Vec3> x, double range,
                           std::span<const double> reach, Searched& searched)
{
    searched.reach.resize(parts.size());
    searched.boxes.set(std::ssize(parts),
                       [&](std::int64_t k)
                       {
                           const Part& part = parts[static_cast<std::size_t>(k)];
                           Box box;
                           double largest = 0.0;
                           for (const std::int32_t vertex : part)
                           {
                               box.include(at(x, vertex));
                               largest = std::max(largest, reach[static_cast<std::size_t>(vertex)]);
                           }
                           searched.reach[static_cast<std::size_t>(k)] = largest;
                           const double wide = 0.5 * range + largest;
                           return Box{box.low - Vec3{wide, wide, wide}, box.high + Vec3{wide, wide, wide}};
                       });
}

/// Leaves of what is searched the tiles about the parts of a share: those that meet these parts, and those that meet
/// the former. So all pairs are found of every owner that has one with a part of the share.
void SurfaceParts::search_about(const SurfaceShare& share, std::span<const Vec3> x, double cell)
{
    const Box bounds = bounding_box(x);
    const auto for_all = [&](auto&& act)
    {
        act(std::span<const std::array<std::int32_t, 1>>(vertices_), searched_vertices_.boxes);
        act(std::span<const Triangle>(triangles_), searched_triangles_.boxes);
        act(std::span<const Edge>(edges_), searched_edges_.boxes);
    };
    CellMarks own(bounds, cell);
    for_all(
        [&](auto parts, const BoxTiles& boxes)
        {
            for (std::int64_t k = 0; k < std::ssize(parts); ++k)
            {
                if (std::ranges::any_of(parts[static_cast<std::size_t>(k)],
                                        [&](std::int32_t vertex) { return share.has(vertex); }))
                {
                    own.mark(boxes.box(k));
                }
            }
        });
    CellMarks beside(bounds, cell);
    for_all(
        [&](auto parts, const BoxTiles& boxes)
        {
            for (std::int32_t tile = 0; tile < boxes.tile_count(); ++tile)
            {
                const std::int64_t end = std::min(std::ssize(parts), std::int64_t{tile + 1} * BoxTiles::width);
                const bool is_near = own.meets(boxes.box_around(tile));
                for (std::int64_t k = std::int64_t{tile} * BoxTiles::width; is_near && k < end; ++k)
                {
                    const Box box = boxes.box(k);
                    if (own.meets(box))
                    {
                        beside.mark(box);
                    }
                }
            }
        });
    for_all(
        [&](auto, BoxTiles& boxes)
        {
            std::vector<std::uint8_t> is_wanted(static_cast<std::size_t>(boxes.tile_count()));
            parallel_for(boxes.tile_count(),
                         [&](std::int64_t tile)
                         {
                             const Box around = boxes.box_around(static_cast<std::int32_t>(tile));
                             is_wanted[static_cast<std::size_t>(tile)] = beside.meets(around) ? 1 : 0;
                         });
            boxes.keep(is_wanted);
        });
}

/// Leaves the pairs of which an owner may push a vertex of the share, or be pushed by it.
template <class Pair>
void SurfaceParts::keep_owners(const SurfaceShare& share, std::size_t owners, std::vector<Pair>& pairs) const
{
    std::vector<std::uint8_t> is_of_share(owners);
    for (const Pair& pair : pairs)
    {
        if (std::ranges::any_of(vertices_of(pair), [&](std::int32_t vertex) { return share.has(vertex); }))
        {
            for (const std::int32_t owner : owners_of(pair))
            {
                is_of_share[static_cast<std::size_t>(owner)] = 1;
            }
        }
    }
    std::erase_if(pairs,
                  [&](const Pair& pair)
                  {
                      return std::ranges::none_of(owners_of(pair), [&](std::int32_t owner)
                                                  { return is_of_share[static_cast<std::size_t>(owner)] != 0; });
                  });
}

void SurfaceParts::find_candidates(std::span<const Vec3> x, double range, std::span<const double> reach,
                                   const SurfaceShare& share, Candidates& found)
{
    enclose<std::array<std::int32_t, 1>>(vertices_, x, range, reach, searched_vertices_);
    enclose<Triangle>(triangles_, x, range, reach, searched_triangles_);
    enclose<Edge>(edges_, x, range, reach, searched_edges_);
    if (share.is_part())
    {
        search_about(share, x, 8.0 * range);
    }
    const auto measured = [&](auto& pairs) { measure(x, pairs); };
    find_pairs(
        searched_vertices_, searched_triangles_, range, found.vertex_triangle,
        [&](std::int32_t vertex, std::int32_t triangle) {
            return VertexTriangle{vertices_[static_cast<std::size_t>(vertex)][0], triangle, 0.0};
        },
        [&](const VertexTriangle& pair)
        {
            const Triangle& corner = triangles_[static_cast<std::size_t>(pair.triangle)];
            return (pair.vertex != corner[0]) & (pair.vertex != corner[1]) & (pair.vertex != corner[2]) &
                   ((pair.vertex < wall_) | (corner[0] < wall_));
        },
        measured);
    find_pairs(
        searched_edges_, searched_edges_, range, found.edge_edge,
        [](std::int32_t first, std::int32_t second) {
            return EdgeEdge{first, second, 0.0};
        },
        [&](const EdgeEdge& pair)
        {
            const Edge& a = edges_[static_cast<std::size_t>(pair.first)];
            const Edge& b = edges_[static_cast<std::size_t>(pair.second)];
            return (a[0] != b[0]) & (a[0] != b[1]) & (a[1] != b[0]) & (a[1] != b[1]) &
                   ((a[0] < wall_) | (b[0] < wall_));
        },
        measured);
    if (share.is_part())
    {
        keep_owners(share, vertices_.size(), found.vertex_triangle);
        keep_owners(share, edges_.size(), found.edge_edge);
    }
}

} // namespace corticle::contact
