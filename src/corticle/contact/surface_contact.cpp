// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/distance.hpp"

#include <limits>

namespace corticle
{

namespace
{

constexpr double skin_in_spacings = 0.4;
constexpr double travel_share = 0.4; ///< of the distance; both sides together use 0.8 of it

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

} // namespace

SurfaceContact::SurfaceContact(std::vector<Triangle> triangles, std::span<const Vec3> rest, std::vector<double> masses,
                               double spacing, const ContactOptions& options)
    : triangles_(std::move(triangles)), edges_(unique_edges(triangles_)), masses_(std::move(masses)),
      dhat_(options.distance * spacing), skin_(skin_in_spacings * spacing), stiffness_(options.stiffness),
      vertex_gap_(rest.size(), dhat_), edge_gap_(edges_.size(), dhat_), closest_pair_(edges_.size(), -1),
      travel_limit_(rest.size())
{
    refresh_candidates(rest);
    for (const VertexTriangle& pair : candidates_.vertex_triangle)
    {
        double& gap = vertex_gap_[static_cast<std::size_t>(pair.vertex)];
        gap = std::min(gap, measure(pair, rest).distance);
    }
    for (const EdgeEdge& pair : candidates_.edge_edge)
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

template <class Pair>
void SurfaceContact::measure_all(std::span<const Pair> pairs, std::span<const Vec3> x, std::vector<Push>& pushes) const
{
    pushes.resize(pairs.size());
    parallel_for(std::ssize(pairs), [&](std::int64_t k)
                 { pushes[static_cast<std::size_t>(k)] = measure(pairs[static_cast<std::size_t>(k)], x); });
}

void SurfaceContact::refresh_candidates(std::span<const Vec3> x)
{
    if (listed_at_.size() == x.size())
    {
        const double moved = parallel_reduce(
            std::ssize(x), 0.0,
            [&](std::int64_t begin, std::int64_t end)
            {
                double largest = 0.0;
                for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
                {
                    largest = std::max(largest, squared_norm(x[k] - listed_at_[k]));
                }
                return largest;
            },
            [](double& total, double part) { total = std::max(total, part); });
        if (moved < 0.25 * skin_ * skin_)
        {
            return;
        }
    }
    candidates_ = find_candidates(x, triangles_, edges_, dhat_ + skin_);
    listed_at_.assign(x.begin(), x.end());
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

void SurfaceContact::push_vertices(std::span<const Vec3> v, double dt, std::span<Vec3> forces,
                                   ContactResponse& response)
{
    const auto& pairs = candidates_.vertex_triangle;
    for (std::size_t first = 0; first < pairs.size();)
    {
        std::size_t closest = first;
        std::size_t k = first;
        for (; k < pairs.size() && pairs[k].vertex == pairs[first].vertex; ++k)
        {
            closest = vertex_push_[k].distance < vertex_push_[closest].distance ? k : closest;
            if (vertex_push_[k].distance < dhat_)
            {
                limit_travel(vertices_of(pairs[k]), vertex_push_[k].distance);
            }
        }
        const double gap = vertex_gap_[static_cast<std::size_t>(pairs[first].vertex)];
        if (vertex_push_[closest].distance < gap)
        {
            apply(vertices_of(pairs[closest]), vertex_push_[closest], gap, v, dt, forces, response);
        }
        first = k;
    }
}

void SurfaceContact::push_edges(std::span<const Vec3> v, double dt, std::span<Vec3> forces, ContactResponse& response)
{
    const auto& pairs = candidates_.edge_edge;
    const auto consider = [&](std::int32_t edge, std::size_t pair)
    {
        std::int32_t& closest = closest_pair_[static_cast<std::size_t>(edge)];
        if (closest < 0 || edge_push_[pair].distance < edge_push_[static_cast<std::size_t>(closest)].distance)
        {
            closest = static_cast<std::int32_t>(pair);
        }
    };
    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
        if (edge_push_[k].distance < dhat_)
        {
            limit_travel(vertices_of(pairs[k]), edge_push_[k].distance);
            consider(pairs[k].first, k);
            consider(pairs[k].second, k);
        }
    }
    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
        const auto index = static_cast<std::int32_t>(k);
        const Push& push = edge_push_[k];
        const double gap = std::min(edge_gap_[static_cast<std::size_t>(pairs[k].first)],
                                    edge_gap_[static_cast<std::size_t>(pairs[k].second)]);
        const bool mutual = closest_pair_[static_cast<std::size_t>(pairs[k].first)] == index &&
                            closest_pair_[static_cast<std::size_t>(pairs[k].second)] == index;
        const bool inside =
            push.weight[0] > 0.0 && push.weight[1] > 0.0 && push.weight[2] < 0.0 && push.weight[3] < 0.0;
        if (mutual && inside && push.distance < gap)
        {
            apply(vertices_of(pairs[k]), push, gap, v, dt, forces, response);
        }
    }
    for (const EdgeEdge& pair : pairs)
    {
        closest_pair_[static_cast<std::size_t>(pair.first)] = -1;
        closest_pair_[static_cast<std::size_t>(pair.second)] = -1;
    }
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    refresh_candidates(x);
    std::fill(travel_limit_.begin(), travel_limit_.end(), travel_share * dhat_);
    measure_all<VertexTriangle>(candidates_.vertex_triangle, x, vertex_push_);
    measure_all<EdgeEdge>(candidates_.edge_edge, x, edge_push_);
    ContactResponse response;
    push_vertices(v, dt, forces, response);
    push_edges(v, dt, forces, response);
    return response;
}

} // namespace corticle
