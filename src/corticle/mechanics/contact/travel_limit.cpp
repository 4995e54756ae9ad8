// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/travel_limit.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace corticle::contact
{

namespace
{

constexpr double travel_share = 0.4;  ///< of the range of near pairs, for each of two parts
constexpr double closing_share = 0.8; ///< of the separation above the least

constexpr std::size_t size_of_first(const VertexTriangle&)
{
    return 1;
}
constexpr std::size_t size_of_first(const EdgeEdge&)
{
    return 2;
}

Vec3 mean_of(std::span<const Vec3> vectors)
{
    const Vec3 sum = parallel_reduce(
        std::ssize(vectors), Vec3{},
        [&](std::int64_t begin, std::int64_t end)
        { return std::accumulate(vectors.begin() + begin, vectors.begin() + end, Vec3{}); },
        [](Vec3& total, const Vec3& part) { total += part; });
    return sum / static_cast<double>(vectors.size());
}

/// How far apart the vertices of both parts lie along a direction.
/// @param position  of one of the four vertices, by its number in the surface
template <class Position>
double separation_along(const Vec3& direction, const std::array<std::int32_t, 4>& vertex, std::size_t first_size,
                        const Position& position)
{
    double lowest_of_first = std::numeric_limits<double>::infinity();
    double highest_of_second = -lowest_of_first;
    for (std::size_t k = 0; k < 4; ++k)
    {
        const double height = dot(direction, position(vertex[k]));
        if (k < first_size)
        {
            lowest_of_first = std::min(lowest_of_first, height);
        }
        else
        {
            highest_of_second = std::max(highest_of_second, height);
        }
    }
    return lowest_of_first - highest_of_second;
}

/// Whether the lengths of the displacements alone say that a pair keeps apart.
/// @param ways  the largest of the first part plus that of the second [mm]
bool keeps_apart(double distance, double ways, double least)
{
    return ways <= closing_share * std::max(distance - least, 0.0);
}

/// The separation that a step must leave.
double required_separation(double now, double least)
{
    return now - closing_share * std::max(now - least, 0.0);
}

} // namespace

TravelLimit::TravelLimit(std::vector<double> masses, std::vector<double> vertex_least, std::vector<double> edge_least,
                         std::int32_t wall)
    : masses_(std::move(masses)), vertex_least_(std::move(vertex_least)), edge_least_(std::move(edge_least)),
      largest_least_(std::max(*std::ranges::max_element(vertex_least_), *std::ranges::max_element(edge_least_))),
      wall_(std::min(masses_.size(), static_cast<std::size_t>(wall))), parent_(masses_.size()),
      of_group_(masses_.size())
{
    std::iota(parent_.begin(), parent_.end(), 0);
}

double TravelLimit::least_of(const VertexTriangle& pair) const
{
    return vertex_least_[static_cast<std::size_t>(pair.vertex)];
}

double TravelLimit::least_of(const EdgeEdge& pair) const
{
    return std::max(edge_least_[static_cast<std::size_t>(pair.first)],
                    edge_least_[static_cast<std::size_t>(pair.second)]);
}

bool TravelLimit::stays_apart(const NearPairs& near, double least_distance, const Travel& travel,
                              std::span<const std::int32_t> places)
{
    if (!(travel.longest < travel_share * near.range()))
    {
        return false;
    }
    mean_ = {};
    longest_way_ = travel.longest;
    return keeps_apart(least_distance, 2.0 * longest_way_, largest_least_) ||
           !find_closing(near, [&](std::int32_t vertex) { return travel.dt * travel.velocity[places[vertex]]; });
}

std::span<const std::int32_t> TravelLimit::apply(const NearPairs& near, std::span<Vec3> displacements)
{
    changed_.clear();
    stay_with_the_mean(displacements, travel_share * near.range());
    const SurfaceShare& share = near.share();
    while (share.any(find_closing(near, [&](std::int32_t vertex) { return displacements[vertex]; })))
    {
        join_closing(share, displacements);
        move_together(displacements);
    }
    for (const std::int32_t vertex : grouped_)
    {
        parent_[static_cast<std::size_t>(vertex)] = vertex;
    }
    changed_.insert(changed_.end(), grouped_.begin(), grouped_.end());
    grouped_.clear();
    std::ranges::sort(changed_);
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    return changed_;
}

/// No displacement differs from their mean by more than `farthest`.
void TravelLimit::stay_with_the_mean(std::span<Vec3> displacements, double farthest)
{
    mean_ = mean_of(displacements.first(wall_));
    longest_way_ = 0.0;
    for (std::size_t k = 0; k < displacements.size(); ++k)
    {
        const Vec3 way = displacements[k] - mean_;
        const double length = norm(way);
        if (length > farthest)
        {
            displacements[k] = mean_ + (farthest / length) * way;
            changed_.push_back(static_cast<std::int32_t>(k));
        }
        longest_way_ = std::max(longest_way_, std::min(length, farthest));
    }
}

std::int32_t TravelLimit::group_of(std::int32_t vertex) const
{
    while (parent_[static_cast<std::size_t>(vertex)] != vertex)
    {
        vertex = parent_[static_cast<std::size_t>(vertex)];
    }
    return vertex;
}

bool TravelLimit::in_one_group(const FourVertices& vertex) const
{
    const std::int32_t group = group_of(vertex[0]);
    return std::all_of(vertex.begin() + 1, vertex.end(), [&](std::int32_t v) { return group_of(v) == group; });
}

void TravelLimit::join(std::int32_t a, std::int32_t b)
{
    const std::int32_t first = group_of(a);
    const std::int32_t second = group_of(b);
    parent_[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
}

/// False where the lengths of the displacements of its vertices alone say that a pair keeps apart.
template <class Pair, class DisplacementOf>
bool TravelLimit::may_close(const FourVertices& vertex, const Pair& pair, const DisplacementOf& displacement_of) const
{
    std::array<double, 2> way{};
    for (std::size_t k = 0; k < 4; ++k)
    {
        double& longest = way[k < size_of_first(pair) ? 0 : 1];
        longest = std::max(longest, norm(displacement_of(vertex[k]) - mean_));
    }
    return !keeps_apart(pair.distance, way[0] + way[1], least_of(pair)); // NaN too
}

/// Sets `found` to those of the near pairs of a block whose parts would come too close.
template <class Pair, class DisplacementOf>
void TravelLimit::find_closing(const NearPairs& near, const std::vector<Pair>& pairs,
                               const DisplacementOf& displacement_of, std::vector<FourVertices>& found) const
{
    found.clear();
    std::vector<Pair> suspects;
    for (const Pair& pair : pairs)
    {
        if (!keeps_apart(pair.distance, 2.0 * longest_way_, largest_least_))
        {
            const FourVertices vertex = near.parts().vertices_of(pair);
            if (may_close(vertex, pair, displacement_of) && !in_one_group(vertex))
            {
                suspects.push_back(pair);
            }
        }
    }
    std::vector<ClosestPoints> points(suspects.size());
    const std::span<const Vec3> x = near.positions();
    near.parts().locate(x, suspects, points);
    for (std::size_t k = 0; k < suspects.size(); ++k)
    {
        const FourVertices vertex = near.parts().vertices_of(suspects[k]);
        const Vec3 direction = normalized(points[k].between);
        const std::size_t first = size_of_first(suspects[k]);
        const double now = separation_along(direction, vertex, first, [&](std::int32_t i) { return x[i]; });
        const double then =
            separation_along(direction, vertex, first, [&](std::int32_t i) { return x[i] + displacement_of(i); });
        // Written so that a NaN counts as closing.
        if (!(now > 0.0 && then >= required_separation(now, least_of(suspects[k]))))
        {
            found.push_back(vertex);
        }
    }
}

/// Finds the pairs that would come too close. @return whether there are any
template <class DisplacementOf>
bool TravelLimit::find_closing(const NearPairs& near, const DisplacementOf& displacement_of)
{
    const auto& of_vertices = near.vertex_triangle();
    const auto& of_edges = near.edge_edge();
    closing_.resize(of_vertices.size() + of_edges.size());
    const auto finding = [&](const auto& blocks, std::size_t first)
    {
        return BlockLoop{std::ssize(blocks),
                         [&, first](std::int64_t block, std::int64_t)
                         { find_closing(near, blocks[block], displacement_of, closing_[first + block]); },
                         1};
    };
    parallel_runs(finding(of_vertices, 0), finding(of_edges, of_vertices.size()));
    return !std::ranges::all_of(closing_, [](const auto& found) { return found.empty(); });
}

/// Joins the vertices of pairs that would come too close, whichever rank has found them.
void TravelLimit::join_closing(const SurfaceShare& share, std::span<const Vec3> displacements)
{
    if (grouped_.empty())
    {
        wanted_.assign(displacements.begin(), displacements.end());
    }
    std::vector<FourVertices> closing;
    for_each_of(closing_, [&](const FourVertices& vertex) { closing.push_back(vertex); });
    for (const FourVertices& vertex : share.of_all(std::move(closing)))
    {
        for (const std::int32_t v : vertex)
        {
            join(vertex[0], v);
            grouped_.push_back(v);
        }
    }
}

/// Gives every group the mean displacement of its vertices, weighted with their masses.
void TravelLimit::move_together(std::span<Vec3> displacements)
{
    std::ranges::sort(grouped_);
    grouped_.erase(std::unique(grouped_.begin(), grouped_.end()), grouped_.end());
    for (const std::int32_t vertex : grouped_)
    {
        of_group_[static_cast<std::size_t>(vertex)] = {};
    }
    for (const std::int32_t vertex : grouped_)
    {
        Moving& group = of_group_[static_cast<std::size_t>(group_of(vertex))];
        group.mass += masses_[static_cast<std::size_t>(vertex)];
        group.moment += masses_[static_cast<std::size_t>(vertex)] * wanted_[static_cast<std::size_t>(vertex)];
    }
    for (const std::int32_t vertex : grouped_)
    {
        const Moving& group = of_group_[static_cast<std::size_t>(group_of(vertex))];
        displacements[static_cast<std::size_t>(vertex)] = group.moment / group.mass;
    }
}

} // namespace corticle::contact
