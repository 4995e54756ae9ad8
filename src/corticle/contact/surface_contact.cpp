// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/distance.hpp"

#include <concepts>

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

/// Those whose closest pair may push: the vertex of a triangle, or both edges.
std::array<std::int32_t, 1> owners_of(const VertexTriangle& pair)
{
    return {pair.vertex};
}
std::array<std::int32_t, 2> owners_of(const EdgeEdge& pair)
{
    return {pair.first, pair.second};
}

} // namespace

SurfaceContact::SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                               std::vector<double> masses, double spacing, const ContactOptions& options)
    : parts_(triangles, rest), masses_(std::move(masses)), dhat_(options.distance * spacing), spacing_(spacing),
      stiffness_(options.stiffness), reach_(rest.size()), step_(rest.size()), vertex_path_(rest.size()),
      triangle_path_(parts_.triangles().size()), edge_path_(parts_.edges().size()), travel_limit_(rest.size())
{
    refresh_candidates(rest, std::vector<Vec3>(rest.size()), 0.0);
    set_gaps<VertexTriangle>(std::ssize(rest), candidates_.vertex_triangle, vertices_);
    set_gaps<EdgeEdge>(std::ssize(parts_.edges()), candidates_.edge_edge, edge_pairs_);
}

/// Gaps of `count` vertices or edges from the candidates at rest.
template <class Pair>
void SurfaceContact::set_gaps(std::int64_t count, std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.gap.assign(static_cast<std::size_t>(count), dhat_);
    watched.closest.assign(static_cast<std::size_t>(count), -1);
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

SurfaceContact::Push SurfaceContact::measure(const VertexTriangle& pair, std::span<const Vec3> x) const
{
    const auto vertex = vertices_of(pair);
    const auto b = closest_on_triangle(at(x, vertex[0]), at(x, vertex[1]), at(x, vertex[2]), at(x, vertex[3]));
    const Vec3 between =
        at(x, vertex[0]) - (b[0] * at(x, vertex[1]) + b[1] * at(x, vertex[2]) + b[2] * at(x, vertex[3]));
    return {normalized(between), {1.0, -b[0], -b[1], -b[2]}};
}

SurfaceContact::Push SurfaceContact::measure(const EdgeEdge& pair, std::span<const Vec3> x) const
{
    const auto vertex = vertices_of(pair);
    const auto [s, t] = closest_of_segments(at(x, vertex[0]), at(x, vertex[1]), at(x, vertex[2]), at(x, vertex[3]));
    const Vec3 between =
        (1.0 - s) * at(x, vertex[0]) + s * at(x, vertex[1]) - (1.0 - t) * at(x, vertex[2]) - t * at(x, vertex[3]);
    return {normalized(between), {1.0 - s, s, t - 1.0, -t}};
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

template <class Pair>
void SurfaceContact::watch(std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    watched.due.resize(pairs.size());
    parallel_for(std::ssize(pairs),
                 [&](std::int64_t k) { watched.due[k] = path_of(pairs[k]) + pairs[k].distance - dhat_; });
}

template <class Pair>
void SurfaceContact::measure_due(std::span<const Vec3> x, std::span<const Pair> pairs, Watch<Pair>& watched) const
{
    const double rounding = 1e-9 * dhat_; // more than additions round off
    parallel_list(std::ssize(pairs), watched.near,
                  [&](std::int64_t begin, std::int64_t end, std::vector<Pair>& near)
                  {
                      std::array<std::int64_t, parallel_block> places;
                      std::size_t count = 0;
                      for (std::int64_t k = begin; k < end; ++k)
                      {
                          places[count] = k;
                          count += watched.due[k] < path_of(pairs[k]) + rounding ? 1 : 0;
                      }
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
                  });
}

/// Notes how far the vertices have moved, and says whether one of them has left its reach.
bool SurfaceContact::follow(std::span<const Vec3> x)
{
    const std::int64_t left = parallel_reduce(
        std::ssize(x), std::int64_t{0},
        [&](std::int64_t begin, std::int64_t end)
        {
            std::int64_t outside = 0;
            for (std::int64_t k = begin; k < end; ++k)
            {
                step_[k] = norm(x[k] - last_x_[k]);
                vertex_path_[k] += step_[k];
                last_x_[k] = x[k];
                outside += squared_norm(x[k] - listed_at_[k]) > reach_[k] * reach_[k] ? 1 : 0;
            }
            return outside;
        },
        [](std::int64_t& total, std::int64_t part) { total += part; });
    parallel_for(std::ssize(parts_.triangles()),
                 [&](std::int64_t k)
                 {
                     const Triangle& corner = parts_.triangles()[static_cast<std::size_t>(k)];
                     triangle_path_[k] += std::max({step_[corner[0]], step_[corner[1]], step_[corner[2]]});
                 });
    parallel_for(std::ssize(parts_.edges()),
                 [&](std::int64_t k)
                 {
                     const Edge& end = parts_.edges()[static_cast<std::size_t>(k)];
                     edge_path_[k] += std::max(step_[end[0]], step_[end[1]]);
                 });
    return left > 0;
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
    watch<VertexTriangle>(candidates_.vertex_triangle, vertices_);
    watch<EdgeEdge>(candidates_.edge_edge, edge_pairs_);
    listed_at_.assign(x.begin(), x.end());
    last_x_ = listed_at_;
}

void SurfaceContact::limit_travel(const std::array<std::int32_t, 4>& vertex, double distance)
{
    for (const std::int32_t k : vertex)
    {
        double& limit = travel_limit_[static_cast<std::size_t>(k)];
        limit = std::min(limit, travel_share * distance);
    }
}

void SurfaceContact::apply(const std::array<std::int32_t, 4>& vertex, const Push& push, double distance, double gap,
                           std::span<const Vec3> v, double dt, std::span<Vec3> forces, ContactResponse& response) const
{
    double inverse_mass = 0.0;
    Vec3 approach;
    for (std::size_t k = 0; k < 4; ++k)
    {
        inverse_mass += push.weight[k] * push.weight[k] / masses_[static_cast<std::size_t>(vertex[k])];
        approach += push.weight[k] * at(v, vertex[k]);
    }
    const double mass = 1.0 / inverse_mass;
    const double stiffness = stiffness_ * mass / (dt * dt);
    const double damping = 2.0 * std::sqrt(stiffness * mass);
    const double speed = std::min(0.0, dot(approach, push.direction));
    const double depth = gap - distance;
    const Vec3 force = (stiffness * depth - damping * speed) * push.direction;
    for (std::size_t k = 0; k < 4; ++k)
    {
        forces[static_cast<std::size_t>(vertex[k])] += push.weight[k] * force;
    }
    response.energy += 0.5 * stiffness * depth * depth;
    response.dissipated_power += damping * speed * speed;
    ++response.active;
}

/// Of the triangles near a vertex the closest pushes; two edges push each other that are each other's closest.
template <class Pair>
void SurfaceContact::choose(Watch<Pair>& watched)
{
    const std::vector<Pair>& near = watched.near;
    for (std::int32_t m = 0; m < std::ssize(near); ++m)
    {
        limit_travel(vertices_of(near[m]), near[m].distance);
        for (const std::int32_t owner : owners_of(near[m]))
        {
            std::int32_t& closest = watched.closest[owner];
            closest = closest < 0 || near[m].distance < near[closest].distance ? m : closest;
        }
    }
    watched.pushing.clear();
    for (std::int32_t m = 0; m < std::ssize(near); ++m)
    {
        double gap = dhat_;
        bool is_closest = true;
        for (const std::int32_t owner : owners_of(near[m]))
        {
            gap = std::min(gap, watched.gap[owner]);
            is_closest = is_closest && watched.closest[owner] == m;
        }
        if (is_closest && near[m].distance < gap)
        {
            watched.pushing.push_back({near[m], gap, {}});
        }
    }
    for (const Pair& pair : near)
    {
        for (const std::int32_t owner : owners_of(pair))
        {
            watched.closest[owner] = -1;
        }
    }
}

/// Edges push between their ends only; those belong to the vertices.
template <class Pair>
void SurfaceContact::push(std::span<const Vec3> x, std::span<const Vec3> v, double dt, Watch<Pair>& watched,
                          std::span<Vec3> forces, ContactResponse& response) const
{
    constexpr std::int64_t pairs_at_a_time = 64;
    parallel_blocks(
        std::ssize(watched.pushing),
        [&](std::int64_t begin, std::int64_t end)
        {
            for (std::int64_t m = begin; m < end; ++m)
            {
                watched.pushing[m].push = measure(watched.pushing[m].pair, x);
            }
        },
        pairs_at_a_time);
    for (const auto& [pair, gap, push] : watched.pushing)
    {
        const auto& w = push.weight;
        if (std::same_as<Pair, VertexTriangle> || (w[0] > 0.0 && w[1] > 0.0 && w[2] < 0.0 && w[3] < 0.0))
        {
            apply(vertices_of(pair), push, pair.distance, gap, v, dt, forces, response);
        }
    }
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    refresh_candidates(x, v, dt);
    std::fill(travel_limit_.begin(), travel_limit_.end(), travel_share * dhat_);
    measure_due<VertexTriangle>(x, candidates_.vertex_triangle, vertices_);
    measure_due<EdgeEdge>(x, candidates_.edge_edge, edge_pairs_);
    ContactResponse response;
    choose(vertices_);
    choose(edge_pairs_);
    push(x, v, dt, vertices_, forces, response);
    push(x, v, dt, edge_pairs_, forces, response);
    return response;
}

} // namespace corticle
