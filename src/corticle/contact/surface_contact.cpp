// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace corticle
{

namespace
{

constexpr double least_reach = 0.08;    ///< [spacings]
constexpr double largest_reach = 0.8;   ///< [spacings]
constexpr double steps_of_reach = 30.0; ///< for which a vertex that keeps its speed stays within its reach
constexpr double travel_share = 0.4;    ///< of the distance; both sides together use 0.8 of it

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

/// Calls act(pair) for the pairs of all blocks, in order.
template <class Pair, class Act>
void for_each_of(const std::vector<std::vector<Pair>>& blocks, Act&& act)
{
    for (const std::vector<Pair>& block : blocks)
    {
        for (const Pair& pair : block)
        {
            act(pair);
        }
    }
}

/// Those whose closest pair may push: the vertex of a triangle, or both edges.
std::array<std::int32_t, 1> owners_of(const VertexTriangle& pair)
{
    return {pair.vertex};
}
std::array<std::int32_t, 2> owners_of(const EdgeEdge& pair)
{
    return {pair.first, pair.second};
}

/// Edges push between their ends only; those belong to the vertices.
bool acts(const VertexTriangle&, const std::array<double, 4>&)
{
    return true;
}
bool acts(const EdgeEdge&, const std::array<double, 4>& weight)
{
    return weight[0] > 0.0 && weight[1] > 0.0 && weight[2] < 0.0 && weight[3] < 0.0;
}

} // namespace

SurfaceContact::SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                               std::vector<double> masses, double spacing, const ContactOptions& options)
    : parts_(triangles, rest), masses_(std::move(masses)), dhat_(options.distance * spacing), spacing_(spacing),
      stiffness_(options.stiffness), reach_(rest.size()), step_(rest.size()), vertex_path_(rest.size()),
      triangle_path_(parts_.triangles().size()), edge_path_(parts_.edges().size()), travel_limit_(rest.size())
{
    refresh_candidates(rest, std::vector<Vec3>(rest.size()), 0.0);
    vertices_.gap.assign(rest.size(), dhat_);
    vertices_.least.resize(rest.size() + parts_.triangles().size());
    vertices_.travel_limit.resize(rest.size());
    edge_pairs_.travel_limit.resize(rest.size());
    edge_pairs_.gap.assign(parts_.edges().size(), dhat_);
    edge_pairs_.least.resize(parts_.edges().size());
    set_gaps<VertexTriangle>(candidates_.vertex_triangle, vertices_);
    set_gaps<EdgeEdge>(candidates_.edge_edge, edge_pairs_);
}

/// Gaps of the owners from the candidates at rest.
template <class Pair>
void SurfaceContact::set_gaps(std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    for (const Pair& pair : pairs)
    {
        for (const std::int32_t owner : owners_of(pair))
        {
            watched.gap[owner] = std::min(watched.gap[owner], pair.distance);
        }
    }
}

std::array<std::int32_t, 4> SurfaceContact::vertices_of(const VertexTriangle& pair) const
{
    return corticle::vertices_of(pair, parts_.triangles().data());
}

std::array<std::int32_t, 4> SurfaceContact::vertices_of(const EdgeEdge& pair) const
{
    return corticle::vertices_of(pair, parts_.edges().data());
}

/// Numbers of both parts of a pair, those of triangles after those of the vertices.
std::array<std::int32_t, 2> SurfaceContact::parts_of(const VertexTriangle& pair) const
{
    return {pair.vertex, static_cast<std::int32_t>(masses_.size()) + pair.triangle};
}

std::array<std::int32_t, 2> SurfaceContact::parts_of(const EdgeEdge& pair) const
{
    return {pair.first, pair.second};
}

double SurfaceContact::path_of(const VertexTriangle& pair) const
{
    return vertex_path_[static_cast<std::size_t>(pair.vertex)] +
           triangle_path_[static_cast<std::size_t>(pair.triangle)];
}

double SurfaceContact::path_of(const EdgeEdge& pair) const
{
    return edge_path_[static_cast<std::size_t>(pair.first)] + edge_path_[static_cast<std::size_t>(pair.second)];
}

/// Sets the paths at which candidates just found may be near.
template <class Pair>
auto SurfaceContact::watching(std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.due.resize(pairs.size());
    return each(std::ssize(pairs), [this, pairs, &watched](std::int64_t k)
                { watched.due[k] = path_of(pairs[k]) + pairs[k].distance - dhat_; });
}

/// Measures the candidates that may be near.
template <class Pair>
auto SurfaceContact::measuring(std::span<const Vec3> x, std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.near.resize(static_cast<std::size_t>(block_count(std::ssize(pairs))));
    return BlockLoop{std::ssize(pairs), [this, x, pairs, &watched](std::int64_t begin, std::int64_t end)
                     {
                         const double rounding = 1e-9 * dhat_; // more than additions round off
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
                             watched.due[places[m]] = path_of(near[m]) + near[m].distance - dhat_;
                             near[kept] = near[m];
                             kept += near[m].distance < dhat_ ? 1 : 0;
                         }
                         near.resize(kept);
                     }};
}

/// Notes how far the vertices have moved, and says whether one of them has left its reach.
bool SurfaceContact::follow(std::span<const Vec3> x)
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
void SurfaceContact::refresh_candidates(std::span<const Vec3> x, std::span<const Vec3> v, double dt)
{
    if (listed_at_.size() == x.size() && !follow(x))
    {
        return;
    }
    parallel_for(
        std::ssize(x), [&](std::int64_t k)
        { reach_[k] = std::min(largest_reach * spacing_, least_reach * spacing_ + steps_of_reach * dt * norm(v[k])); });
    parts_.find_candidates(x, dhat_, reach_, candidates_);
    parallel_runs(watching<VertexTriangle>(candidates_.vertex_triangle, vertices_),
                  watching<EdgeEdge>(candidates_.edge_edge, edge_pairs_));
    listed_at_.assign(x.begin(), x.end());
    last_x_ = listed_at_;
}

/// Of the triangles near a vertex the closest pushes; two edges push each other that are each other's closest. Of
/// several as close it is the first.
template <class Pair>
void SurfaceContact::choose(Watch<Pair>& watched) const
{
    constexpr double taken = -1.0;
    std::ranges::fill(watched.travel_limit, travel_share * dhat_);
    std::ranges::fill(watched.least, std::numeric_limits<double>::infinity());
    for_each_of(watched.near,
                [&](const Pair& pair)
                {
                    for (const std::int32_t part : parts_of(pair))
                    {
                        watched.least[part] = std::min(watched.least[part], pair.distance);
                    }
                });
    watched.pushing.clear();
    for_each_of(watched.near,
                [&](const Pair& pair)
                {
                    const auto parts = parts_of(pair);
                    const std::array is_closest{pair.distance == watched.least[parts[0]],
                                                pair.distance == watched.least[parts[1]]};
                    if (!is_closest[0] && !is_closest[1])
                    {
                        return;
                    }
                    for (const std::int32_t vertex : vertices_of(pair))
                    {
                        double& limit = watched.travel_limit[vertex];
                        limit = std::min(limit, travel_share * pair.distance);
                    }
                    const auto owners = owners_of(pair); // the first part, or both
                    if (is_closest[0] && is_closest[owners.size() - 1])
                    {
                        double gap = dhat_;
                        for (const std::int32_t owner : owners)
                        {
                            gap = std::min(gap, watched.gap[owner]);
                        }
                        if (pair.distance < gap)
                        {
                            watched.pushing.push_back({pair, gap});
                        }
                    }
                    for (std::size_t k = 0; k < 2; ++k)
                    {
                        watched.least[parts[k]] = is_closest[k] ? taken : watched.least[parts[k]];
                    }
                });
}

template <class Pair>
SurfaceContact::Push SurfaceContact::push_of(const Pushing<Pair>& pushing, const ClosestPoints& points,
                                             std::span<const Vec3> v, double dt) const
{
    const auto vertex = vertices_of(pushing.pair);
    const double depth = pushing.gap - pushing.pair.distance;
    double inverse_mass = 0.0;
    Vec3 approach;
    for (std::size_t k = 0; k < 4; ++k)
    {
        const double weight = points.weight[k];
        inverse_mass += weight * weight / masses_[static_cast<std::size_t>(vertex[k])];
        approach += weight * at(v, vertex[k]);
    }
    const double mass = 1.0 / inverse_mass;
    const double stiffness = stiffness_ * mass / (dt * dt);
    const double damping = 2.0 * std::sqrt(stiffness * mass);
    const Vec3 direction = normalized(points.between);
    const double speed = std::min(0.0, dot(approach, direction));
    return {vertex,
            points.weight,
            (stiffness * depth - damping * speed) * direction,
            0.5 * stiffness * depth * depth,
            damping * speed * speed,
            acts(pushing.pair, points.weight)};
}

/// Works out the pushes of a list, to where they are wanted.
template <class Pair>
auto SurfaceContact::working_out(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                 std::span<const Pushing<Pair>> pushing, Push* pushes) const
{
    constexpr std::int64_t pairs_at_a_time = 64;
    return BlockLoop{std::ssize(pushing),
                     [this, x, v, dt, pushing, pushes](std::int64_t begin, std::int64_t end)
                     {
                         std::array<Pair, pairs_at_a_time> pairs;
                         std::array<ClosestPoints, pairs_at_a_time> points;
                         const auto count = static_cast<std::size_t>(end - begin);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             pairs[m] = pushing[begin + m].pair;
                         }
                         parts_.locate(x, std::span(pairs).first(count), points);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             pushes[begin + m] = push_of(pushing[begin + m], points[m], v, dt);
                         }
                     },
                     pairs_at_a_time};
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    refresh_candidates(x, v, dt);
    parallel_runs(measuring<VertexTriangle>(x, candidates_.vertex_triangle, vertices_),
                  measuring<EdgeEdge>(x, candidates_.edge_edge, edge_pairs_));
    parallel_both([&] { choose(vertices_); }, [&] { choose(edge_pairs_); });
    pushes_.resize(vertices_.pushing.size() + edge_pairs_.pushing.size());
    parallel_runs(working_out<VertexTriangle>(x, v, dt, vertices_.pushing, pushes_.data()),
                  working_out<EdgeEdge>(x, v, dt, edge_pairs_.pushing, pushes_.data() + vertices_.pushing.size()),
                  each(std::ssize(travel_limit_), [&](std::int64_t k)
                       { travel_limit_[k] = std::min(vertices_.travel_limit[k], edge_pairs_.travel_limit[k]); }));
    ContactResponse response;
    for (const Push& push : pushes_)
    {
        if (push.acts)
        {
            for (std::size_t k = 0; k < 4; ++k)
            {
                forces[static_cast<std::size_t>(push.vertex[k])] += push.weight[k] * push.force;
            }
            response.energy += push.energy;
            response.dissipated_power += push.dissipated_power;
            ++response.active;
        }
    }
    return response;
}

} // namespace corticle
