// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/near_pairs.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/simd.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace corticle::contact
{

namespace
{

constexpr double least_reach = 0.08;    ///< [spacings]
constexpr double largest_reach = 0.8;   ///< [spacings]
constexpr double steps_of_reach = 30.0; ///< like the last one, that a vertex makes within its reach

std::vector<std::int32_t> marked(const std::vector<std::uint8_t>& is_marked)
{
    std::vector<std::int32_t> numbers;
    for (std::size_t k = 0; k < is_marked.size(); ++k)
    {
        if (is_marked[k] != 0)
        {
            numbers.push_back(static_cast<std::int32_t>(k));
        }
    }
    return numbers;
}

/// A float below a number.
float rounded_down(double a)
{
    const auto near = static_cast<float>(a);
    return near - std::abs(near) * std::numeric_limits<float>::epsilon();
}

} // namespace

NearPairs::NearPairs(std::span<const Triangle> triangles, std::span<const Vec3> rest, double range, double spacing,
                     std::int32_t wall, SurfaceShare share)
    : parts_(triangles, rest, wall), share_(std::move(share)), range_(range), spacing_(spacing),
      x_(rest.begin(), rest.end()), reach_(rest.size()), step_(rest.size()), vertex_path_(rest.size()),
      triangle_path_(parts_.triangles().size()), edge_path_(parts_.edges().size())
{
    find_candidates();
    measure();
}

double NearPairs::path_of(const VertexTriangle& pair) const
{
    return vertex_path_[pair.vertex] + triangle_path_[pair.triangle];
}

double NearPairs::path_of(const EdgeEdge& pair) const
{
    return edge_path_[pair.first] + edge_path_[pair.second];
}

template <class Pair>
NearPairs::Watched NearPairs::watched(const Pair& pair) const
{
    const auto& [first, second, distance] = pair;
    return {first, second, rounded_down(path_of(pair) + distance - range_)};
}

template <class Pair>
auto NearPairs::watching(std::span<const Pair> pairs, Watch<Pair>& watch) const
{
    watch.candidates.resize(pairs.size());
    return each(std::ssize(pairs), [this, pairs, &watch](std::int64_t k) { watch.candidates[k] = watched(pairs[k]); });
}

/// Measures the candidates that may be near.
template <class Pair>
auto NearPairs::measuring(Watch<Pair>& watch) const
{
    watch.near.resize(static_cast<std::size_t>(block_count(std::ssize(watch.candidates))));
    return BlockLoop{std::ssize(watch.candidates), [this, &watch](std::int64_t begin, std::int64_t end)
                     {
                         const double rounding = 1e-9 * range_; // more than additions round off
                         std::array<Watched*, parallel_block> due;
                         std::size_t count = 0;
                         for (std::int64_t k = begin; k < end; ++k)
                         {
                             Watched& pair = watch.candidates[k];
                             due[count] = &pair;
                             count += pair.due < path_of(Pair{pair.first, pair.second, 0.0}) + rounding ? 1 : 0;
                         }
                         std::vector<Pair>& near = watch.near[begin / parallel_block];
                         near.resize(count);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             near[m] = {due[m]->first, due[m]->second, 0.0};
                         }
                         parts_.measure(x_, near);
                         std::size_t kept = 0;
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             *due[m] = watched(near[m]);
                             near[kept] = near[m];
                             kept += near[m].distance < range_ ? 1 : 0;
                         }
                         near.resize(kept);
                     }};
}

/// The parts that candidates are made of, and the own vertices.
void NearPairs::choose_followed()
{
    if (!share_.is_part() && !followed_vertices_.empty())
    {
        return;
    }
    const std::uint8_t all = share_.is_part() ? 0 : 1;
    std::vector<std::uint8_t> vertices(x_.size(), all);
    std::vector<std::uint8_t> triangles(parts_.triangles().size(), all);
    std::vector<std::uint8_t> edges(parts_.edges().size(), all);
    const auto note = [&](const auto& pairs, std::vector<std::uint8_t>* firsts, std::vector<std::uint8_t>& seconds)
    {
        for (const auto& pair : pairs)
        {
            for (const std::int32_t vertex : parts_.vertices_of(pair))
            {
                vertices[static_cast<std::size_t>(vertex)] = 1;
            }
            const auto& [first, second, distance] = pair;
            if (firsts != nullptr)
            {
                (*firsts)[static_cast<std::size_t>(first)] = 1;
            }
            seconds[static_cast<std::size_t>(second)] = 1;
        }
    };
    if (share_.is_part())
    {
        for (std::int32_t vertex = 0; vertex < std::ssize(vertices); ++vertex)
        {
            vertices[static_cast<std::size_t>(vertex)] = share_.has(vertex) ? 1 : 0;
        }
        note(candidates_.vertex_triangle, nullptr, triangles);
        note(candidates_.edge_edge, &edges, edges);
    }
    followed_vertices_ = marked(vertices);
    followed_triangles_ = marked(triangles);
    followed_edges_ = marked(edges);
}

/// Notes where the vertices are and how far they have moved, and says whether one of them has left its reach.
bool NearPairs::follow(std::span<const Vec3> x, std::span<const std::int32_t> places)
{
    std::atomic<bool> has_left = false;
    const std::span<const std::int32_t> vertices = followed_vertices_;
    parallel_runs(BlockLoop{std::ssize(vertices), [&](std::int64_t begin, std::int64_t end)
                            {
                                std::int64_t outside = 0;
                                for (std::int64_t m = begin; m < end; ++m)
                                {
                                    read_soon(&x[places[vertices[std::min(m + places_ahead, end - 1)]]]);
                                    const std::int32_t k = vertices[m];
                                    const Vec3 now = x[places[k]];
                                    step_[k] = norm(now - x_[k]);
                                    vertex_path_[k] += step_[k];
                                    x_[k] = now;
                                    // A way within the reach ends there, too.
                                    if (vertex_path_[k] > reach_[k])
                                    {
                                        outside += norm(now - listed_at_[k]) > reach_[k] ? 1 : 0;
                                    }
                                }
                                if (outside > 0)
                                {
                                    has_left = true;
                                }
                            }});
    parallel_runs(each(std::ssize(followed_triangles_),
                       [&](std::int64_t m)
                       {
                           const std::int32_t k = followed_triangles_[static_cast<std::size_t>(m)];
                           const Triangle& corner = parts_.triangles()[static_cast<std::size_t>(k)];
                           triangle_path_[k] += std::max({step_[corner[0]], step_[corner[1]], step_[corner[2]]});
                       }),
                  each(std::ssize(followed_edges_),
                       [&](std::int64_t m)
                       {
                           const std::int32_t k = followed_edges_[static_cast<std::size_t>(m)];
                           const Edge& end = parts_.edges()[static_cast<std::size_t>(k)];
                           edge_path_[k] += std::max(step_[end[0]], step_[end[1]]);
                       }));
    return share_.any(has_left);
}

void NearPairs::find_candidates()
{
    for (std::size_t k = 0; k < reach_.size(); ++k)
    {
        reach_[k] = std::min(largest_reach * spacing_, least_reach * spacing_ + steps_of_reach * step_[k]);
    }
    share_.gather(std::span(reach_)); // of the others' vertices, whose steps may not be known
    parts_.find_candidates(x_, range_, reach_, share_, candidates_);
    choose_followed();
    std::ranges::fill(vertex_path_, 0.0);
    std::ranges::fill(triangle_path_, 0.0);
    std::ranges::fill(edge_path_, 0.0);
    parallel_runs(watching<VertexTriangle>(candidates_.vertex_triangle, vertices_),
                  watching<EdgeEdge>(candidates_.edge_edge, edges_));
    listed_at_ = x_;
}

void NearPairs::measure()
{
    parallel_runs(measuring(vertices_), measuring(edges_));
}

void NearPairs::update(std::span<const Vec3> x, std::span<const std::int32_t> places)
{
    if (follow(x, places))
    {
        for (std::size_t k = 0; share_.is_part() && k < x_.size(); ++k)
        {
            x_[k] = x[places[k]];
        }
        find_candidates();
    }
    measure();
}

} // namespace corticle::contact
