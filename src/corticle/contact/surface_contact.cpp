// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/distance.hpp"

#include <limits>

namespace corticle
{

namespace
{

constexpr double skin_in_spacings = 0.4; ///< twice and three times as much finds fewer times, but more pairs: slower
constexpr std::int64_t pairs_per_block = 8192; ///< that one thread looks through for those that are due
constexpr double travel_share = 0.4;           ///< of the distance; both sides together use 0.8 of it

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

template <class Pair>
void SurfaceContact::watch(std::vector<Pair> pairs, Watch<Pair>& watched) const
{
    watched.pairs = std::move(pairs);
    watched.due.resize(watched.pairs.size());
    parallel_for(std::ssize(watched.pairs),
                 [&](std::int64_t k) { watched.due[k] = path_ + 0.5 * (watched.pairs[k].distance - dhat_); });
}

template <class Pair>
void SurfaceContact::measure_due(std::span<const Vec3> x, Watch<Pair>& watched) const
{
    const double reached = path_ + 1e-9 * dhat_; // ahead of what additions round off
    watched.now = parallel_reduce(
        std::ssize(watched.pairs), std::vector<std::int32_t>{},
        [&](std::int64_t begin, std::int64_t end)
        {
            std::vector<std::int32_t> found;
            for (std::int64_t k = begin; k < end; ++k)
            {
                if (watched.due[k] < reached)
                {
                    found.push_back(static_cast<std::int32_t>(k));
                }
            }
            return found;
        },
        [](std::vector<std::int32_t>& all, const std::vector<std::int32_t>& part)
        { all.insert(all.end(), part.begin(), part.end()); },
        pairs_per_block);
    watched.push.resize(watched.now.size());
    parallel_for(std::ssize(watched.now),
                 [&](std::int64_t m)
                 {
                     const std::int32_t k = watched.now[m];
                     watched.push[m] = measure(watched.pairs[k], x);
                     watched.due[k] = path_ + 0.5 * (watched.push[m].distance - dhat_);
                 });
}

/// Notes how far the vertices have moved; finds the candidates anew when one may be missing.
void SurfaceContact::refresh_candidates(std::span<const Vec3> x)
{
    struct Moved
    {
        double since_listed = 0.0; ///< squared
        double since_last = 0.0;   ///< squared
    };
    if (listed_at_.size() == x.size())
    {
        const Moved moved = parallel_reduce(
            std::ssize(x), Moved{},
            [&](std::int64_t begin, std::int64_t end)
            {
                Moved largest;
                for (std::int64_t k = begin; k < end; ++k)
                {
                    largest.since_listed = std::max(largest.since_listed, squared_norm(x[k] - listed_at_[k]));
                    largest.since_last = std::max(largest.since_last, squared_norm(x[k] - last_x_[k]));
                    last_x_[k] = x[k];
                }
                return largest;
            },
            [](Moved& total, const Moved& part)
            {
                total.since_listed = std::max(total.since_listed, part.since_listed);
                total.since_last = std::max(total.since_last, part.since_last);
            });
        path_ += std::sqrt(moved.since_last);
        if (moved.since_listed < 0.25 * skin_ * skin_)
        {
            return;
        }
    }
    Candidates found = find_candidates(x, triangles_, edges_, dhat_ + skin_);
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

void SurfaceContact::push_vertices(std::span<const Vec3> v, double dt, std::span<Vec3> forces,
                                   ContactResponse& response)
{
    const auto pair = [&](std::size_t m) -> const VertexTriangle& { return vertices_.pairs[vertices_.now[m]]; };
    const std::vector<Push>& push = vertices_.push;
    for (std::size_t first = 0; first < push.size();)
    {
        std::size_t closest = first;
        std::size_t m = first;
        for (; m < push.size() && pair(m).vertex == pair(first).vertex; ++m)
        {
            closest = push[m].distance < push[closest].distance ? m : closest;
            if (push[m].distance < dhat_)
            {
                limit_travel(vertices_of(pair(m)), push[m].distance);
            }
        }
        const double gap = vertex_gap_[static_cast<std::size_t>(pair(first).vertex)];
        if (push[closest].distance < gap)
        {
            apply(vertices_of(pair(closest)), push[closest], gap, v, dt, forces, response);
        }
        first = m;
    }
}

void SurfaceContact::push_edges(std::span<const Vec3> v, double dt, std::span<Vec3> forces, ContactResponse& response)
{
    const auto pair = [&](std::size_t m) -> const EdgeEdge& { return edge_pairs_.pairs[edge_pairs_.now[m]]; };
    const std::vector<Push>& pushes = edge_pairs_.push;
    const auto consider = [&](std::int32_t edge, std::size_t m)
    {
        std::int32_t& closest = closest_pair_[static_cast<std::size_t>(edge)];
        if (closest < 0 || pushes[m].distance < pushes[static_cast<std::size_t>(closest)].distance)
        {
            closest = static_cast<std::int32_t>(m);
        }
    };
    for (std::size_t m = 0; m < pushes.size(); ++m)
    {
        if (pushes[m].distance < dhat_)
        {
            limit_travel(vertices_of(pair(m)), pushes[m].distance);
            consider(pair(m).first, m);
            consider(pair(m).second, m);
        }
    }
    for (std::size_t m = 0; m < pushes.size(); ++m)
    {
        const auto index = static_cast<std::int32_t>(m);
        const Push& push = pushes[m];
        const EdgeEdge& edges = pair(m);
        const double gap = std::min(edge_gap_[static_cast<std::size_t>(edges.first)],
                                    edge_gap_[static_cast<std::size_t>(edges.second)]);
        const bool mutual = closest_pair_[static_cast<std::size_t>(edges.first)] == index &&
                            closest_pair_[static_cast<std::size_t>(edges.second)] == index;
        const bool inside =
            push.weight[0] > 0.0 && push.weight[1] > 0.0 && push.weight[2] < 0.0 && push.weight[3] < 0.0;
        if (mutual && inside && push.distance < gap)
        {
            apply(vertices_of(edges), push, gap, v, dt, forces, response);
        }
    }
    for (std::size_t m = 0; m < pushes.size(); ++m)
    {
        closest_pair_[static_cast<std::size_t>(pair(m).first)] = -1;
        closest_pair_[static_cast<std::size_t>(pair(m).second)] = -1;
    }
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    refresh_candidates(x);
    std::fill(travel_limit_.begin(), travel_limit_.end(), travel_share * dhat_);
    measure_due(x, vertices_);
    measure_due(x, edge_pairs_);
    ContactResponse response;
    push_vertices(v, dt, forces, response);
    push_edges(v, dt, forces, response);
    return response;
}

} // namespace corticle
