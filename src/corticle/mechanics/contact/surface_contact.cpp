// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace corticle
{

namespace
{

/// Those who repel the other part if the pair is their closest: the vertex of a triangle, or both edges.
std::array<std::int32_t, 1> owners_of(const VertexTriangle& pair)
{
    return {pair.vertex};
}
std::array<std::int32_t, 2> owners_of(const EdgeEdge& pair)
{
    return {pair.first, pair.second};
}

/// Least distances of the owners; never within round-off, also where surfaces all but touch in the reference.
std::vector<double> least_separations(std::span<const Barrier> barriers, double range)
{
    std::vector<double> least;
    least.reserve(barriers.size());
    for (const Barrier& barrier : barriers)
    {
        least.push_back(std::max(barrier.least_distance(), 1e-9 * range));
    }
    return least;
}

} // namespace

SurfaceContact::SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                               std::vector<double> masses, double spacing, double frequency,
                               const ContactOptions& options)
    : near_(triangles, rest, options.distance * spacing, spacing),
      masses_(std::move(masses)), loads_{std::vector<Load>(rest.size()), std::vector<Load>(rest.size())}
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
        edges_.barrier.push_back(barrier(0.5 * (masses_[a] + masses_[b])));
    }
    set_gaps(near_.vertex_triangle(), vertices_);
    set_gaps(near_.edge_edge(), edges_);
    travel_limit_.emplace(masses_, least_separations(vertices_.barrier, range),
                          least_separations(edges_.barrier, range));
}

/// Gaps of the owners from the near pairs at rest.
template <class Pair>
void SurfaceContact::set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const
{
    owners.closest[0].resize(owners.barrier.size());
    owners.closest[1].resize(owners.barrier.size());
    for_each_of(near,
                [&](const Pair& pair)
                {
                    for (const std::int32_t owner : owners_of(pair))
                    {
                        owners.barrier[owner].gap = std::min(owners.barrier[owner].gap, pair.distance);
                    }
                });
}

/// Finds the closest of one half of the near pairs for every owner, of several as close the first.
template <class Pair>
void SurfaceContact::choose(const NearPairs::Blocks<Pair>& near, std::size_t half, Owners<Pair>& owners) const
{
    std::vector<Pair>& closest = owners.closest[half];
    double& least = owners.least[half];
    for (Pair& pair : closest)
    {
        pair.distance = std::numeric_limits<double>::infinity();
    }
    least = std::numeric_limits<double>::infinity();
    const std::size_t middle = near.size() / 2;
    for (const std::vector<Pair>& block : half == 0 ? std::span(near).first(middle) : std::span(near).subspan(middle))
    {
        for (const Pair& pair : block)
        {
            least = std::min(least, pair.distance);
            for (const std::int32_t owner : owners_of(pair))
            {
                if (pair.distance < closest[owner].distance)
                {
                    closest[owner] = pair;
                }
            }
        }
    }
}

/// Joins what was found in both halves, and lists the owners that repel.
template <class Pair>
void SurfaceContact::settle(Owners<Pair>& owners) const
{
    auto& [closest, closest_of_second] = owners.closest;
    owners.repelling.clear();
    for (std::size_t owner = 0; owner < closest.size(); ++owner)
    {
        if (closest_of_second[owner].distance < closest[owner].distance)
        {
            closest[owner] = closest_of_second[owner];
        }
        if (closest[owner].distance < owners.barrier[owner].gap)
        {
            owners.repelling.push_back(static_cast<std::int32_t>(owner));
        }
    }
}

/// Finds who repels what.
void SurfaceContact::find_repelling()
{
    parallel_blocks(
        4,
        [this](std::int64_t task, std::int64_t)
        {
            const auto half = static_cast<std::size_t>(task % 2);
            task < 2 ? choose(near_.edge_edge(), half, edges_) : choose(near_.vertex_triangle(), half, vertices_);
        },
        1);
    parallel_both([&] { settle(edges_); }, [&] { settle(vertices_); });
}

double SurfaceContact::least_distance() const
{
    return std::min({vertices_.least[0], vertices_.least[1], edges_.least[0], edges_.least[1]});
}

double SurfaceContact::energy() const
{
    const auto of_owners = [](const auto& owners)
    {
        return parallel_sum(std::ssize(owners.repelling),
                            [&](std::int64_t k)
                            {
                                const std::int32_t owner = owners.repelling[k];
                                return owners.barrier[owner].energy(owners.closest[0][owner].distance);
                            });
    };
    return of_owners(vertices_) + of_owners(edges_);
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
                             pairs[m] = owners.closest[0][owners.repelling[begin + m]];
                         }
                         near_.parts().locate(x, std::span(pairs).first(count), points);
                         for (std::size_t m = 0; m < count; ++m)
                         {
                             const Barrier& barrier = owners.barrier[owners.repelling[begin + m]];
                             const double distance = pairs[m].distance;
                             pushes[begin + m] = {near_.parts().vertices_of(pairs[m]), points[m].weight,
                                                  barrier.repulsion(distance) * normalized(points[m].between),
                                                  std::sqrt(barrier.stiffness(distance))};
                         }
                     },
                     pairs_at_a_time};
}

/// Largest eigenvalue of the springs of all pushes on the masses, from above. With a row b of sqrt(k / m_i) w_i for
/// each push it is that of the matrix of b_p · b_q, whose rows sum to no more than sqrt(k_p) sum_i |w_i| r_i / m_i.
double SurfaceContact::largest_rate() const
{
    const double squared = parallel_reduce(
        std::ssize(pushes_), 0.0,
        [this](std::int64_t begin, std::int64_t end)
        {
            double largest = 0.0;
            for (std::int64_t p = begin; p < end; ++p)
            {
                const Push& push = pushes_[p];
                double row = 0.0;
                for (std::size_t k = 0; k < 4; ++k)
                {
                    const std::int32_t i = push.vertex[k];
                    row += std::abs(push.weight[k]) * loads_[0][i].root_stiffness / masses_[i];
                }
                largest = std::max(largest, push.root_stiffness * row);
            }
            return largest;
        },
        [](double& total, double part) { total = std::max(total, part); });
    return std::sqrt(squared);
}

/// Adds the pushes up to what acts on each vertex, half of them at a time.
void SurfaceContact::add_up()
{
    const std::size_t middle = pushes_.size() / 2;
    const auto add = [this](std::span<const Push> pushes, std::vector<Load>& loads)
    {
        std::ranges::fill(loads, Load{});
        for (const Push& push : pushes)
        {
            for (std::size_t k = 0; k < 4; ++k)
            {
                Load& load = loads[static_cast<std::size_t>(push.vertex[k])];
                load.force += push.weight[k] * push.force;
                load.root_stiffness += std::abs(push.weight[k]) * push.root_stiffness;
            }
        }
    };
    parallel_both([&] { add(std::span(pushes_).first(middle), loads_[0]); },
                  [&] { add(std::span(pushes_).subspan(middle), loads_[1]); });
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<Vec3> forces)
{
    near_.update(x);
    find_repelling();
    ContactResponse response;
    response.active = std::ssize(vertices_.repelling) + std::ssize(edges_.repelling);
    if (response.active == 0)
    {
        return response;
    }
    pushes_.resize(static_cast<std::size_t>(response.active));
    parallel_runs(working_out(x, vertices_, pushes_.data()),
                  working_out(x, edges_, pushes_.data() + vertices_.repelling.size()));
    add_up();
    parallel_runs(each(std::ssize(forces),
                       [&](std::int64_t k)
                       {
                           loads_[0][k].root_stiffness += loads_[1][k].root_stiffness;
                           forces[k] += loads_[0][k].force + loads_[1][k].force;
                       }));
    response.largest_rate = largest_rate();
    return response;
}

} // namespace corticle
