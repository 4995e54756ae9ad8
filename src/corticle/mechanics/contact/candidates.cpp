// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/candidates.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/wide_group.hpp"
#include "corticle/mechanics/contact/box_tiles.hpp"
#include "corticle/mesh/distance.hpp"
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

/// The closest points of eight pairs.
struct WideClosestPoints
{
    WideVec3 between;
    WideLanes weight[4];
};

CORTICLE_INLINE WideClosestPoints closest_points(const WideVec3 (&corner)[4], const VertexTriangle&)
{
    const auto& [p, a, b, c] = corner;
    const auto weight = closest_on_triangle(p, a, b, c);
    return {p - (weight[0] * a + weight[1] * b + weight[2] * c),
            {broadcast<WideLanes>(1.0), -weight[0], -weight[1], -weight[2]}};
}
CORTICLE_INLINE WideClosestPoints closest_points(const WideVec3 (&corner)[4], const EdgeEdge&)
{
    const auto& [a, b, c, d] = corner;
    const auto [s, t] = closest_of_segments(a, b, c, d);
    return {a + s * (b - a) - c - t * (d - c), {1.0 - s, s, t - 1.0, -t}};
}

/// Calls take(group, points) with the closest points of the pairs, eight at a time.
template <class Part, class Pair, class Take>
CORTICLE_INLINE void for_groups(const Vec3* x, const Part* parts, std::span<const Pair> pairs, Take&& take)
{
    for (std::int64_t first = 0; first < std::ssize(pairs); first += wide_lanes)
    {
        const WideGroup group{first, std::min(wide_lanes, std::ssize(pairs) - first)};
        std::array<std::array<std::int32_t, wide_lanes>, 4> vertices;
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            const auto four = vertices_of(pairs[static_cast<std::size_t>(group.at(lane))], parts);
            for (std::size_t c = 0; c < 4; ++c)
            {
                vertices[c][lane] = four[c];
            }
        }
        WideVec3 corner[4];
        for (std::size_t c = 0; c < 4; ++c)
        {
            const std::int32_t* of_corner = vertices[c].data();
            corner[c] = WideGroup{0, wide_lanes}.gather_vectors([x, of_corner](std::int64_t lane) -> const Vec3&
                                                                { return x[of_corner[lane]]; });
        }
        take(group, closest_points(corner, Pair{}));
    }
}

template <class Part, class Pair>
CORTICLE_INLINE void measure_groups(const Vec3* x, const Part* parts, std::span<Pair> pairs)
{
    for_groups<Part, Pair>(x, parts, pairs,
                           [&](const WideGroup& group, const WideClosestPoints& points)
                           {
                               WideLanes distance = square_root(squared_norm(points.between));
                               for (int lane = 0; lane < group.count; ++lane)
                               {
                                   pairs[static_cast<std::size_t>(group.first + lane)].distance =
                                       at_lane(distance, lane);
                               }
                           });
}

template <class Part, class Pair>
CORTICLE_INLINE void locate_groups(const Vec3* x, const Part* parts, std::span<const Pair> pairs, ClosestPoints* points)
{
    for_groups<Part, Pair>(x, parts, pairs,
                           [&](const WideGroup& group, WideClosestPoints found)
                           {
                               group.scatter_vectors(found.between,
                                                     [points](std::int64_t k) -> Vec3& { return points[k].between; });
                               for (int lane = 0; lane < group.count; ++lane)
                               {
                                   for (std::size_t c = 0; c < 4; ++c)
                                   {
                                       points[group.first + lane].weight[c] = at_lane(found.weight[c], lane);
                                   }
                               }
                           });
}

CORTICLE_EVERY_ISA void measure_pairs(const Vec3* x, const Triangle* triangles, std::span<VertexTriangle> pairs)
{
    measure_groups(x, triangles, pairs);
}
CORTICLE_EVERY_ISA void measure_pairs(const Vec3* x, const Edge* edges, std::span<EdgeEdge> pairs)
{
    measure_groups(x, edges, pairs);
}
CORTICLE_EVERY_ISA void locate_pairs(const Vec3* x, const Triangle* triangles, std::span<const VertexTriangle> pairs,
                                     ClosestPoints* points)
{
    locate_groups(x, triangles, pairs, points);
}
CORTICLE_EVERY_ISA void locate_pairs(const Vec3* x, const Edge* edges, std::span<const EdgeEdge> pairs,
                                     ClosestPoints* points)
{
    locate_groups(x, edges, pairs, points);
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

void SurfaceParts::measure(std::span<const Vec3> x, std::span<VertexTriangle> pairs) const
{
    measure_pairs(x.data(), triangles_.data(), pairs);
}

void SurfaceParts::measure(std::span<const Vec3> x, std::span<EdgeEdge> pairs) const
{
    measure_pairs(x.data(), edges_.data(), pairs);
}

void SurfaceParts::locate(std::span<const Vec3> x, std::span<const VertexTriangle> pairs,
                          std::span<ClosestPoints> points) const
{
    locate_pairs(x.data(), triangles_.data(), pairs, points.data());
}

void SurfaceParts::locate(std::span<const Vec3> x, std::span<const EdgeEdge> pairs,
                          std::span<ClosestPoints> points) const
{
    locate_pairs(x.data(), edges_.data(), pairs, points.data());
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

void SurfaceParts::find_candidates(std::span<const Vec3> x, double range, std::span<const double> reach,
                                   Candidates& found)
{
    enclose<std::array<std::int32_t, 1>>(vertices_, x, range, reach, searched_vertices_);
    enclose<Triangle>(triangles_, x, range, reach, searched_triangles_);
    enclose<Edge>(edges_, x, range, reach, searched_edges_);
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
}

} // namespace corticle::contact
