// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/near_pairs.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <atomic>

namespace corticle
{

namespace
{

constexpr double least_reach = 0.08;    ///< [spacings]
constexpr double largest_reach = 0.8;   ///< [spacings]
constexpr double steps_of_reach = 30.0; ///< like the last one, that a vertex makes within its reach

} // namespace

NearPairs::NearPairs(std::span<const Triangle> triangles, std::span<const Vec3> rest, double range, double spacing)
    : parts_(triangles, rest), range_(range), spacing_(spacing), reach_(rest.size()), step_(rest.size()),
      vertex_path_(rest.size()), triangle_path_(parts_.triangles().size()), edge_path_(parts_.edges().size())
{
    update(rest);
}

double NearPairs::path_of(const VertexTriangle& pair) const
{
    return vertex_path_[static_cast<std::size_t>(pair.vertex)] +
           triangle_path_[static_cast<std::size_t>(pair.triangle)];
}

double NearPairs::path_of(const EdgeEdge& pair) const
{
    return edge_path_[static_cast<std::size_t>(pair.first)] + edge_path_[static_cast<std::size_t>(pair.second)];
}

/// Sets the paths at which candidates just found may be near.
template <class Pair>
auto NearPairs::watching(std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.due.resize(pairs.size());
    return each(std::ssize(pairs), [this, pairs, &watched](std::int64_t k)
                { watched.due[k] = path_of(pairs[k]) + pairs[k].distance - range_; });
}

/// Measures the candidates that may be near.
template <class Pair>
auto NearPairs::measuring(std::span<const Vec3> x, std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.near.resize(static_cast<std::size_t>(block_count(std::ssize(pairs))));
    return BlockLoop{std::ssize(pairs), [this, x, pairs, &watched](std::int64_t begin, std::int64_t end)
                     {
                         const double rounding = 1e-9 * range_; // more than additions round off
                         std::array<std::int64_t, parallel_block> places;
                         std::size_t count = 0;
                         for (std::int64_t k = begin; k < end; ++k)
                         {
                             places[count] = k;
                             count += watched.due[k] < path_of(pairs[k]) + rounding ? 1 : 0;
                         }
                         std::vector<Pair>& near = watched.near[begin / parallel_block];
                         near.resize(count);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             near[m] = pairs[places[m]];
                         }
                         parts_.measure(x, near);
                         std::size_t kept = 0;
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             watched.due[places[m]] = path_of(near[m]) + near[m].distance - range_;
                             near[kept] = near[m];
                             kept += near[m].distance < range_ ? 1 : 0;
                         }
                         near.resize(kept);
                     }};
}

/// Notes how far the vertices have moved, and says whether one of them has left its reach.
bool NearPairs::follow(std::span<const Vec3> x)
{
    std::atomic<bool> has_left = false;
    parallel_runs(BlockLoop{std::ssize(x), [&](std::int64_t begin, std::int64_t end)
                            {
                                std::int64_t outside = 0;
                                for (std::int64_t k = begin; k < end; ++k)
                                {
                                    step_[k] = norm(x[k] - last_x_[k]);
                                    vertex_path_[k] += step_[k];
                                    last_x_[k] = x[k];
                                    outside += squared_norm(x[k] - listed_at_[k]) > reach_[k] * reach_[k] ? 1 : 0;
                                }
                                if (outside > 0)
                                {
                                    has_left = true;
                                }
                            }});
    parallel_runs(each(std::ssize(parts_.triangles()),
                       [&](std::int64_t k)
                       {
                           const Triangle& corner = parts_.triangles()[static_cast<std::size_t>(k)];
                           triangle_path_[k] += std::max({step_[corner[0]], step_[corner[1]], step_[corner[2]]});
                       }),
                  each(std::ssize(parts_.edges()),
                       [&](std::int64_t k)
                       {
                           const Edge& end = parts_.edges()[static_cast<std::size_t>(k)];
                           edge_path_[k] += std::max(step_[end[0]], step_[end[1]]);
                       }));
    return has_left;
}

/// Finds the candidates anew when one may be missing.
void NearPairs::refresh_candidates(std::span<const Vec3> x)
{
    if (listed_at_.size() == x.size() && !follow(x))
    {
        return;
    }
    parallel_for(std::ssize(x),
                 [&](std::int64_t k) {
                     reach_[k] = std::min(largest_reach * spacing_, least_reach * spacing_ + steps_of_reach * step_[k]);
                 });
    parts_.find_candidates(x, range_, reach_, candidates_);
    parallel_runs(watching<VertexTriangle>(candidates_.vertex_triangle, vertices_),
                  watching<EdgeEdge>(candidates_.edge_edge, edges_));
    listed_at_.assign(x.begin(), x.end());
    last_x_ = listed_at_;
}

void NearPairs::update(std::span<const Vec3> x)
{
    refresh_candidates(x);
    parallel_runs(measuring<VertexTriangle>(x, candidates_.vertex_triangle, vertices_),
                  measuring<EdgeEdge>(x, candidates_.edge_edge, edges_));
}

} // namespace corticle
