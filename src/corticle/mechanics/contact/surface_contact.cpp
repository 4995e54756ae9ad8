// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/simd.hpp"
#include "corticle/mechanics/contact/owner_blocks.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace corticle::contact
{

namespace
{

constexpr std::int64_t word_bits = 64;

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

std::vector<std::int32_t> as_numbered(std::size_t count)
{
    std::vector<std::int32_t> places(count);
    std::iota(places.begin(), places.end(), 0);
    return places;
}

/// The masses of the vertices, those of a wall replaced by the mean of the others.
std::vector<double> masses_of_barriers(std::vector<double> masses, std::int32_t wall)
{
    if (wall != no_wall)
    {
        const auto others = std::span(masses).first(static_cast<std::size_t>(wall));
        const double mean = std::accumulate(others.begin(), others.end(), 0.0) / static_cast<double>(wall);
        std::fill(masses.begin() + wall, masses.end(), mean);
    }
    return masses;
}

std::span<const Triangle> checked(std::span<const Triangle> triangles, std::span<const Vec3> vertices)
{
    require_triangles(vertices, triangles);
    return triangles;
}

} // namespace

SurfaceContact::SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                               std::vector<double> masses, double spacing, double frequency,
                               const ContactOptions& options, std::vector<std::int32_t> places, std::int32_t wall,
                               SurfaceShare share)
    : wall_(wall), near_(checked(triangles, rest), rest, options.distance * spacing, spacing, wall, std::move(share)),
      masses_(std::move(masses)),
      places_(places.empty() ? as_numbered(rest.size()) : std::move(places)), loads_{std::vector<Vec3>(rest.size()),
                                                                                     std::vector<Vec3>(rest.size())},
      rate_of_vertex_(rest.size())
{
    require_size("masses of the surface", masses_.size(), rest.size());
    require_size("places of the surface", places_.size(), rest.size());
    const double range = near_.range();
    const auto barrier = [&](double mass) {
        return Barrier{range, options.stiffness * mass * frequency * frequency * range};
    };
    const std::vector<double> barrier_masses = masses_of_barriers(masses_, wall);
    for (const double mass : barrier_masses)
    {
        vertices_.barrier.push_back(barrier(mass));
    }
    for (const auto& [a, b] : near_.parts().edges())
    {
        edges_.barrier.push_back(barrier(0.5 * (barrier_masses[a] + barrier_masses[b])));
    }
    make_room(vertices_);
    make_room(edges_);
    set_gaps(near_.vertex_triangle(), vertices_);
    set_gaps(near_.edge_edge(), edges_);
    travel_limit_.emplace(masses_, least_separations(vertices_.barrier, range),
                          least_separations(edges_.barrier, range), wall);
}

template <class Pair>
void SurfaceContact::make_room(Owners<Pair>& owners) const
{
    const std::int64_t count = std::ssize(owners.barrier);
    for (std::size_t half = 0; half < 2; ++half)
    {
        owners.met[half].resize(static_cast<std::size_t>(block_count(count, word_bits)));
        owners.closest[half].resize(owners.barrier.size());
    }
    owners.repelling.resize(owners.barrier.size());
    owners.pushes.resize(owners.barrier.size());
    owners.count.resize(static_cast<std::size_t>(block_count(count, owners_at_a_time)));
}

/// Gaps of the owners from the near pairs at rest, of which the rank that answers for an owner knows all.
template <class Pair>
void SurfaceContact::set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const
{
    struct Gap
    {
        std::int64_t owner;
        double gap;
    };
    std::vector<Gap> gaps;
    for_each_of(near,
                [&](const Pair& pair)
                {
                    for (const std::int32_t owner : owners_of(pair))
                    {
                        if (answers_for(owners, owner))
                        {
                            gaps.push_back({owner, pair.distance});
                        }
                    }
                });
    for (const auto& [owner, distance] : near_.share().of_all(std::move(gaps)))
    {
        double& gap = owners.barrier[static_cast<std::size_t>(owner)].gap;
        gap = std::min(gap, distance);
    }
}

/// Finds the closest of one half of the near pairs for every owner, of several as close the first.
template <class Pair>
void SurfaceContact::choose(const NearPairs::Blocks<Pair>& near, std::size_t half, Owners<Pair>& owners) const
{
    std::vector<Pair>& closest = owners.closest[half];
    std::vector<std::uint64_t>& met = owners.met[half];
    std::ranges::fill(met, 0);
    double least = std::numeric_limits<double>::infinity();
    const std::size_t middle = near.size() / 2;
    for (const std::vector<Pair>& block : half == 0 ? std::span(near).first(middle) : std::span(near).subspan(middle))
    {
        for (const Pair& pair : block)
        {
            least = std::min(least, pair.distance);
            for (const std::int32_t owner : owners_of(pair))
            {
                std::uint64_t& word = met[owner / word_bits];
                const std::uint64_t bit = std::uint64_t{1} << (owner % word_bits);
                // Without a branch, which nobody could predict.
                const bool is_closer = ((word & bit) == 0) | (pair.distance < closest[owner].distance);
                const std::array<const Pair*, 2> from{&closest[owner], &pair};
                closest[owner] = *from[is_closer ? 1 : 0];
                word |= bit;
            }
        }
    }
    owners.least[half] = least;
}

/// Finds the closest of every owner, in both halves of the near pairs.
void SurfaceContact::find_closest()
{
    parallel_blocks(
        4,
        [this](std::int64_t task, std::int64_t)
        {
            const auto half = static_cast<std::size_t>(task % 2);
            task < 2 ? choose(near_.edge_edge(), half, edges_) : choose(near_.vertex_triangle(), half, vertices_);
        },
        1);
}

/// Joins what was found for a block of owners in both halves, and lists those that repel, with their closest.
/// @return how many
template <class Pair>
std::int64_t SurfaceContact::settle(std::int64_t begin, std::int64_t end, Owners<Pair>& owners,
                                    std::span<Pair> repelling) const
{
    std::int64_t count = 0;
    for (std::int64_t word = begin / word_bits; word < block_count(end, word_bits); ++word)
    {
        const std::uint64_t in_first = owners.met[0][word];
        const std::uint64_t in_second = owners.met[1][word];
        for (std::uint64_t left = in_first | in_second; left != 0; left &= left - 1)
        {
            const int bit = std::countr_zero(left);
            const std::int64_t owner = word * word_bits + bit;
            Pair& closest = owners.closest[0][owner];
            const Pair& closest_of_second = owners.closest[1][owner];
            if ((in_second >> bit & 1) != 0 &&
                ((in_first >> bit & 1) == 0 || closest_of_second.distance < closest.distance))
            {
                closest = closest_of_second;
            }
            if (closest.distance < owners.barrier[owner].gap)
            {
                repelling[count] = closest;
                owners.repelling[begin + count] = static_cast<std::int32_t>(owner);
                ++count;
            }
        }
    }
    return count;
}

double SurfaceContact::least_distance() const
{
    return std::min({vertices_.least[0], vertices_.least[1], edges_.least[0], edges_.least[1]});
}

/// Finds who repels what, and works out these pushes.
template <class Pair>
auto SurfaceContact::working_out(Owners<Pair>& owners) const
{
    return BlockLoop{std::ssize(owners.barrier),
                     [this, &owners](std::int64_t begin, std::int64_t end)
                     {
                         std::array<Pair, owners_at_a_time> pairs;
                         std::array<ClosestPoints, owners_at_a_time> points;
                         const std::int64_t count = settle(begin, end, owners, std::span<Pair>(pairs));
                         owners.count[begin / owners_at_a_time] = count;
                         near_.parts().locate(near_.positions(),
                                              std::span(pairs).first(static_cast<std::size_t>(count)), points);
                         for (std::int64_t m = 0; m < count; ++m)
                         {
                             const Barrier& barrier = owners.barrier[owners.repelling[begin + m]];
                             const double distance = pairs[m].distance;
                             Push& push = owners.pushes[begin + m];
                             push.vertex = near_.parts().vertices_of(pairs[m]);
                             push.weight = points[m].weight;
                             push.force = barrier.repulsion(distance) * normalized(points[m].between);
                             push.force.lane = std::sqrt(barrier.stiffness(distance));
                         }
                     },
                     owners_at_a_time};
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<Vec3> forces)
{
    near_.update(x, places_);
    find_closest();
    parallel_runs(working_out(vertices_), working_out(edges_));
    const std::vector<std::int64_t> counts = count_pushes();
    ContactResponse response;
    response.active = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    if (response.active > 0)
    {
        add_up(counts, response.active);
        give(forces);
        response.largest_rate = largest_rate();
    }
    return response;
}

} // namespace corticle::contact
