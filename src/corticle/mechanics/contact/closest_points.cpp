// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/wide_group.hpp"
#include "corticle/mechanics/contact/candidates.hpp"
#include "corticle/mesh/distance.hpp"

namespace corticle::contact
{

namespace
{

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

} // namespace

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

} // namespace corticle::contact
