// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/distance.hpp"

#include <concepts>
#include <limits>

namespace corticle
{

namespace
{

constexpr double least_reach = 0.05;    ///< [spacings]
constexpr double largest_reach = 0.8;   ///< [spacings]
constexpr double steps_of_reach = 30.0; ///< for which a vertex that keeps its speed stays within its reach
constexpr double travel_share = 0.4;    ///< of the distance; both sides together use 0.8 of it

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

} // namespace

SurfaceContact::SurfaceContact(std::vector<Triangle> triangles, std::span<const Vec3> rest, std::vector<double> masses,
                               double spacing, const ContactOptions& options)
    : triangles_(std::move(triangles)), edges_(unique_edges(triangles_)), masses_(std::move(masses)),
      dhat_(options.distance * spacing), spacing_(spacing), stiffness_(options.stiffness),
      vertex_gap_(rest.size(), dhat_), edge_gap_(edges_.size(), dhat_), reach_(rest.size()), step_(rest.size()),
      vertex_path_(rest.size()), triangle_path_(triangles_.size()), edge_path_(edges_.size()),
      closest_pair_(edges_.size(), -1), travel_limit_(rest.size())
{
    refresh_candidates(rest, std::vector<Vec3>(rest.size()), 0.0);
    for (const VertexTriangle& pair : vertices_.pairs)
    {
        double& gap = vertex_gap_[static_cast<std::size_t>(pair.vertex)];
        gap = std::min(gap, measure(pair, rest).distance);
    }
    for (const EdgeEdge& pair : edge_pairs_.pairs)
    {
        const double distance = measure(pair, rest).distance;
        for (const std::int32_t edge : {pair.first, pair.second})
        {
            double& gap = edge_gap_[static_cast<std::size_t>(edge)];
            gap = std::min(gap, distance);
        }
    }
}

std::array<std::int32_t, 4> SurfaceContact::vertices_of(const VertexTriangle& pair) const
{
    const Triangle& corner = triangles_[static_cast<std::size_t>(pair.triangle)];
    return {pair.vertex, corner[0], corner[1], corner[2]};
}

std::array<std::int32_t, 4> SurfaceContact::vertices_of(const EdgeEdge& pair) const
{
    const Edge& a = edges_[static_cast<std::size_t>(pair.first)];
    const Edge& b = edges_[static_cast<std::size_t>(pair.second)];
    return {a[0], a[1], b[0], b[1]};
}

SurfaceContact::Push SurfaceContact::measure(const VertexTriangle& pair, std::span<const Vec3> x) const
{
    const auto vertex = vertices_of(pair);
    const auto b = closest_on_triangle(at(x, vertex[0]), at(x, vertex[1]), at(x, vertex[2]), at(x, vertex[3]));
    const Vec3 between =
        at(x, vertex[0]) - (b[0] * at(x, vertex[1]) + b[1] * at(x, vertex[2]) + b[2] * at(x, vertex[3]));
    return {norm(between), normalized(between), {1.0, -b[0], -b[1], -b[2]}};
}

SurfaceContact::Push SurfaceContact::measure(const EdgeEdge& pair, std::span<const Vec3> x) const
{
    const auto vertex = vertices_of(pair);
    const auto [s, t] = closest_of_segments(at(x, vertex[0]), at(x, vertex[1]), at(x, vertex[2]), at(x, vertex[3]));
    const Vec3 between =
        (1.0 - s) * at(x, vertex[0]) + s * at(x, vertex[1]) - (1.0 - t) * at(x, vertex[2]) - t * at(x, vertex[3]);
    return {norm(between), normalized(between), {1.0 - s, s, t - 1.0, -t}};
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
void SurfaceContact::watch(std::vector<Pair> pairs, Watch<Pair>& watched) const
{
    watched.pairs = std::move(pairs);
    watched.due.resize(watched.pairs.size());
    parallel_for(std::ssize(watched.pairs), [&](std::int64_t k)
                 { watched.due[k] = path_of(watched.pairs[k]) + watched.pairs[k].distance - dhat_; });
}

template <class Pair>
void SurfaceContact::measure_due(std::span<const Vec3> x, Watch<Pair>& watched) const
{
    const double rounding = 1e-9 * dhat_; // more than additions round off
    watched.near = parallel_reduce(
        std::ssize(watched.pairs), std::vector<Pair>{},
        [&](std::int64_t begin, std::int64_t end)
        {
            std::vector<Pair> found;
            for (std::int64_t k = begin; k < end; ++k)
            {
                const double path = path_of(watched.pairs[k]);
                if (watched.due[k] < path + rounding)
                {
                    const double distance = measure(watched.pairs[k], x).distance;
                    watched.due[k] = path + distance - dhat_;
                    if (distance < dhat_)
                    {
                        found.push_back(watched.pairs[k]);
                        found.back().distance = distance;
                    }
                }
            }
            return found;
        },
        [](std::vector<Pair>& all, const std::vector<Pair>& part) { all.insert(all.end(), part.begin(), part.end()); });
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
    parallel_for(std::ssize(triangles_),
                 [&](std::int64_t k)
                 {
                     const Triangle& corner = triangles_[static_cast<std::size_t>(k)];
                     triangle_path_[k] += std::max({step_[corner[0]], step_[corner[1]], step_[corner[2]]});
                 });
    parallel_for(std::ssize(edges_),
                 [&](std::int64_t k)
                 {
                     const Edge& end = edges_[static_cast<std::size_t>(k)];
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
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        reach_[k] = std::min(largest_reach * spacing_, least_reach * spacing_ + steps_of_reach * dt * norm(v[k]));
    }
    Candidates found = find_candidates(x, triangles_, edges_, dhat_, reach_);
    watch(std::move(found.vertex_triangle), vertices_);
    watch(std::move(found.edge_edge), edge_pairs_);
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

void SurfaceContact::apply(const std::array<std::int32_t, 4>& vertex, const Push& push, double gap,
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
    const double depth = gap - push.distance;
    const Vec3 force = (stiffness * depth - damping * speed) * push.direction;
    for (std::size_t k = 0; k < 4; ++k)
    {
        forces[static_cast<std::size_t>(vertex[k])] += push.weight[k] * force;
    }
    response.energy += 0.5 * stiffness * depth * depth;
    response.dissipated_power += damping * speed * speed;
    ++response.active;
}

/// Of the triangles near a vertex the closest pushes.
void SurfaceContact::choose_vertices()
{
    const std::vector<VertexTriangle>& near = vertices_.near;
    vertices_.pushing.clear();
    for (std::size_t first = 0; first < near.size();)
    {
        const std::int32_t vertex = near[first].vertex;
        std::size_t closest = first;
        std::size_t m = first;
        for (; m < near.size() && near[m].vertex == vertex; ++m)
        {
            closest = near[m].distance < near[closest].distance ? m : closest;
            limit_travel(vertices_of(near[m]), near[m].distance);
        }
        const double gap = vertex_gap_[static_cast<std::size_t>(vertex)];
        if (near[closest].distance < gap)
        {
            vertices_.pushing.push_back({near[closest], gap, {}});
        }
        first = m;
    }
}

/// Two edges push each other that are each other's closest.
void SurfaceContact::choose_edges()
{
    const std::vector<EdgeEdge>& near = edge_pairs_.near;
    const auto consider = [&](std::int32_t edge, std::size_t m)
    {
        std::int32_t& closest = closest_pair_[static_cast<std::size_t>(edge)];
        if (closest < 0 || near[m].distance < near[static_cast<std::size_t>(closest)].distance)
        {
            closest = static_cast<std::int32_t>(m);
        }
    };
    for (std::size_t m = 0; m < near.size(); ++m)
    {
        limit_travel(vertices_of(near[m]), near[m].distance);
        consider(near[m].first, m);
        consider(near[m].second, m);
    }
    edge_pairs_.pushing.clear();
    for (std::size_t m = 0; m < near.size(); ++m)
    {
        const auto index = static_cast<std::int32_t>(m);
        const auto first = static_cast<std::size_t>(near[m].first);
        const auto second = static_cast<std::size_t>(near[m].second);
        const double gap = std::min(edge_gap_[first], edge_gap_[second]);
        if (closest_pair_[first] == index && closest_pair_[second] == index && near[m].distance < gap)
        {
            edge_pairs_.pushing.push_back({near[m], gap, {}});
        }
    }
    for (const EdgeEdge& one : near)
    {
        closest_pair_[static_cast<std::size_t>(one.first)] = -1;
        closest_pair_[static_cast<std::size_t>(one.second)] = -1;
    }
}

/// Edges push between their ends only; those belong to the vertices.
template <class Pair>
void SurfaceContact::push(std::span<const Vec3> x, std::span<const Vec3> v, double dt, Watch<Pair>& watched,
                          std::span<Vec3> forces, ContactResponse& response) const
{
    parallel_for(std::ssize(watched.pushing),
                 [&](std::int64_t m) { watched.pushing[m].push = measure(watched.pushing[m].pair, x); });
    for (const auto& [pair, gap, push] : watched.pushing)
    {
        const auto& w = push.weight;
        if (std::same_as<Pair, VertexTriangle> || (w[0] > 0.0 && w[1] > 0.0 && w[2] < 0.0 && w[3] < 0.0))
        {
            apply(vertices_of(pair), push, gap, v, dt, forces, response);
        }
    }
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    refresh_candidates(x, v, dt);
    std::fill(travel_limit_.begin(), travel_limit_.end(), travel_share * dhat_);
    measure_due(x, vertices_);
    measure_due(x, edge_pairs_);
    ContactResponse response;
    choose_vertices();
    choose_edges();
    push(x, v, dt, vertices_, forces, response);
    push(x, v, dt, edge_pairs_, forces, response);
    return response;
}

} // namespace corticle
