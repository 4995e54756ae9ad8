// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace corticle
{

namespace
{

constexpr double edge_share = 1.0; ///< stiffness of an edge over the mean of its ends

Vec3 at(std::span<const Vec3> x, std::int32_t vertex)
{
    return x[static_cast<std::size_t>(vertex)];
}

/// Those who repel the other part if the pair is their closest: the vertex of a triangle, or both edges.
std::array<std::int32_t, 1> owners_of(const VertexTriangle& pair)
{
    return {pair.vertex};
}
std::array<std::int32_t, 2> owners_of(const EdgeEdge& pair)
{
    return {pair.first, pair.second};
}

std::vector<double> least_separations(std::span<const Barrier> barriers)
{
    std::vector<double> least;
    least.reserve(barriers.size());
    for (const Barrier& barrier : barriers)
    {
        least.push_back(barrier.least_distance());
    }
    return least;
}

} // namespace

SurfaceContact::SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                               std::vector<double> masses, double spacing, double frequency,
                               const ContactOptions& options)
    : near_(triangles, rest, options.distance * spacing, spacing), masses_(std::move(masses)), loads_(rest.size())
{
    const double range = near_.range();
    const auto barrier = [&](double mass) {
        return Barrier{range, options.stiffness * mass * frequency * frequency * range};
    };
    for (const double mass : masses_)
    {
        vertices_.barrier.push_back(barrier(mass));
    }
    for (const auto& [a, b] : near_.parts().edges())
    {
        edges_.barrier.push_back(barrier(edge_share * 0.5 * (masses_[a] + masses_[b])));
    }
    set_gaps(near_.vertex_triangle(), vertices_);
    set_gaps(near_.edge_edge(), edges_);
    travel_limit_.emplace(masses_, least_separations(vertices_.barrier), least_separations(edges_.barrier));
}

/// Gaps of the owners from the near pairs at rest.
template <class Pair>
void SurfaceContact::set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const
{
    owners.closest.resize(owners.barrier.size());
    for_each_of(near,
                [&](const Pair& pair)
                {
                    for (const std::int32_t owner : owners_of(pair))
                    {
                        owners.barrier[owner].gap = std::min(owners.barrier[owner].gap, pair.distance);
                    }
                });
}

/// Finds the closest near pair of every owner, of several as close the first, and who repels it.
template <class Pair>
void SurfaceContact::choose(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const
{
    for (Pair& pair : owners.closest)
    {
        pair.distance = std::numeric_limits<double>::infinity();
    }
    for_each_of(near,
                [&](const Pair& pair)
                {
                    for (const std::int32_t owner : owners_of(pair))
                    {
                        if (pair.distance < owners.closest[owner].distance)
                        {
                            owners.closest[owner] = pair;
                        }
                    }
                });
    owners.repelling.clear();
    for (std::int32_t owner = 0; owner < std::ssize(owners.closest); ++owner)
    {
        if (owners.closest[owner].distance < owners.barrier[owner].gap)
        {
            owners.repelling.push_back(owner);
        }
    }
}

/// Works out the pushes of those who repel, to where they are wanted.
template <class Pair>
auto SurfaceContact::working_out(std::span<const Vec3> x, const Owners<Pair>& owners, Push* pushes) const
{
    constexpr std::int64_t pairs_at_a_time = 64;
    return BlockLoop{std::ssize(owners.repelling),
                     [this, x, &owners, pushes](std::int64_t begin, std::int64_t end)
                     {
                         std::array<Pair, pairs_at_a_time> pairs;
                         std::array<ClosestPoints, pairs_at_a_time> points;
                         const auto count = static_cast<std::size_t>(end - begin);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             pairs[m] = owners.closest[owners.repelling[begin + m]];
                         }
                         near_.parts().locate(x, std::span(pairs).first(count), points);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             const Barrier& barrier = owners.barrier[owners.repelling[begin + m]];
                             const double distance = pairs[m].distance;
                             pushes[begin + m] = {near_.parts().vertices_of(pairs[m]), points[m].weight,
                                                  barrier.repulsion(distance) * normalized(points[m].between),
                                                  std::sqrt(barrier.stiffness(distance)), barrier.energy(distance)};
                         }
                     },
                     pairs_at_a_time};
}

/// Largest eigenvalue of the springs of all pushes on the masses, from above. With a row b of sqrt(k / m_i) w_i for
/// each push it is that of the matrix of b_p · b_q, whose rows sum to no more than sqrt(k_p) sum_i |w_i| r_i / m_i.
double SurfaceContact::largest_rate() const
{
    double largest = 0.0;
    for (const Push& push : pushes_)
    {
        double row = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
        {
            const auto i = static_cast<std::size_t>(push.vertex[k]);
            row += std::abs(push.weight[k]) * loads_[i].root_stiffness / masses_[i];
        }
        largest = std::max(largest, push.root_stiffness * row);
    }
    return std::sqrt(largest);
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                         std::span<Vec3> forces)
{
    near_.update(x, v, dt);
    parallel_both([&] { choose(near_.vertex_triangle(), vertices_); }, [&] { choose(near_.edge_edge(), edges_); });
    pushes_.resize(vertices_.repelling.size() + edges_.repelling.size());
    parallel_runs(working_out(x, vertices_, pushes_.data()),
                  working_out(x, edges_, pushes_.data() + vertices_.repelling.size()));
    ContactResponse response;
    std::ranges::fill(loads_, Load{});
    for (const Push& push : pushes_)
    {
        for (std::size_t k = 0; k < 4; ++k)
        {
            Load& load = loads_[static_cast<std::size_t>(push.vertex[k])];
            load.force += push.weight[k] * push.force;
            load.root_stiffness += std::abs(push.weight[k]) * push.root_stiffness;
        }
        response.energy += push.energy;
    }
    response.active = std::ssize(pushes_);
    response.largest_rate = largest_rate();
    for (std::size_t k = 0; k < loads_.size(); ++k)
    {
        forces[k] += loads_[k].force;
    }
    return response;
}

} // namespace corticle
