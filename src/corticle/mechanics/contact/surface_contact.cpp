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
                               const ContactOptions& options, std::vector<std::int32_t> places, std::int32_t wall)
    : wall_(wall), near_(checked(triangles, rest), rest, options.distance * spacing, spacing, wall),
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

/// Gaps of the owners from the near pairs at rest.
template <class Pair>
void SurfaceContact::set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const
{
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

double SurfaceContact::energy() const
{
    const auto of_owners = [](const auto& owners)
    {
        std::vector<std::int32_t> repelling;
        for (std::size_t block = 0; block < owners.count.size(); ++block)
        {
            const auto first = owners.repelling.begin() + static_cast<std::ptrdiff_t>(block) * owners_at_a_time;
            repelling.insert(repelling.end(), first, first + owners.count[block]);
        }
        return parallel_sum(std::ssize(repelling),
                            [&](std::int64_t k)
                            {
                                const std::int32_t owner = repelling[k];
                                return owners.barrier[owner].energy(owners.closest[0][owner].distance);
                            });
    };
    return of_owners(vertices_) + of_owners(edges_);
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

/// Adds the pushes number first to last of the owners up to what acts on each vertex.
template <class Pair>
void SurfaceContact::add_up(const Owners<Pair>& owners, std::int64_t first, std::int64_t last, std::vector<Vec3>& loads)
{
    std::int64_t number = 0;
    for (std::int64_t block = 0; block < std::ssize(owners.count) && number < last; ++block)
    {
        const Push* pushes = owners.pushes.data() + block * owners_at_a_time;
        const std::int64_t end = std::min(owners.count[block], last - number);
        for (std::int64_t m = std::max<std::int64_t>(0, first - number); m < end; ++m)
        {
            const Lanes force = lanes(pushes[m].force);
            for (std::size_t k = 0; k < 4; ++k)
            {
                const double w = pushes[m].weight[k];
                lanes(loads[pushes[m].vertex[k]]) += Lanes{w, w, w, std::abs(w)} * force;
            }
        }
        number += owners.count[block];
    }
}

/// Adds the pushes up to what acts on each vertex, half of them at a time.
void SurfaceContact::add_up(std::int64_t active)
{
    const std::int64_t of_vertices = std::accumulate(vertices_.count.begin(), vertices_.count.end(), std::int64_t{0});
    const auto add = [&](std::int64_t first, std::int64_t last, std::vector<Vec3>& loads)
    {
        add_up(vertices_, first, std::min(last, of_vertices), loads);
        add_up(edges_, std::max<std::int64_t>(0, first - of_vertices), last - of_vertices, loads);
    };
    parallel_both([&] { add(0, active / 2, loads_[0]); }, [&] { add(active / 2, active, loads_[1]); });
}

/// Of the springs' matrix, see below.
double SurfaceContact::row_of(const Push& push) const
{
    double row = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
        row += std::abs(push.weight[k]) * rate_of_vertex_[push.vertex[k]];
    }
    return push.force.lane * row;
}

/// Sets the largest row of the springs' matrix of each block of owners, see below.
template <class Pair>
auto SurfaceContact::bounding(const Owners<Pair>& owners, std::span<double> largest) const
{
    return BlockLoop{std::ssize(owners.barrier),
                     [this, &owners, largest](std::int64_t begin, std::int64_t)
                     {
                         const std::int64_t block = begin / owners_at_a_time;
                         double most = 0.0;
                         for (std::int64_t m = begin; m < begin + owners.count[block]; ++m)
                         {
                             most = std::max(most, row_of(owners.pushes[m]));
                         }
                         largest[static_cast<std::size_t>(block)] = most;
                     },
                     owners_at_a_time};
}

/// Largest eigenvalue of the springs of all pushes on the masses, from above. With a row b of sqrt(k / m_i) w_i for
/// each push it is that of the matrix of b_p · b_q, whose rows sum to no more than sqrt(k_p) sum_i |w_i| r_i / m_i.
double SurfaceContact::largest_rate() const
{
    std::vector<double> largest(vertices_.count.size() + edges_.count.size());
    parallel_runs(bounding(vertices_, std::span(largest).first(vertices_.count.size())),
                  bounding(edges_, std::span(largest).subspan(vertices_.count.size())));
    return std::sqrt(*std::ranges::max_element(largest));
}

ContactResponse SurfaceContact::evaluate(std::span<const Vec3> x, std::span<Vec3> forces)
{
    near_.update(x, places_);
    find_closest();
    parallel_runs(working_out(vertices_), working_out(edges_));
    ContactResponse response;
    response.active = std::accumulate(vertices_.count.begin(), vertices_.count.end(),
                                      std::accumulate(edges_.count.begin(), edges_.count.end(), std::int64_t{0}));
    if (response.active == 0)
    {
        return response;
    }
    add_up(response.active);
    parallel_runs(BlockLoop{std::ssize(places_), [&](std::int64_t begin, std::int64_t end)
                            {
                                for (std::int64_t k = begin; k < end; ++k)
                                {
                                    read_soon(&forces[places_[std::min(k + places_ahead, end - 1)]]);
                                    Vec3& first = loads_[0][k];
                                    Vec3& second = loads_[1][k];
                                    forces[places_[k]] += first + second;
                                    rate_of_vertex_[k] = (first.lane + second.lane) / masses_[k];
                                    first = {};
                                    second = {};
                                }
                            }});
    response.largest_rate = largest_rate();
    return response;
}

std::string SurfaceContact::stiffest_pair() const
{
    double largest = -1.0;
    std::string words;
    const auto look = [&](const auto& owners, const char* of_particles)
    {
        for (std::int64_t block = 0; block < std::ssize(owners.count); ++block)
        {
            for (std::int64_t m = block * owners_at_a_time; m < block * owners_at_a_time + owners.count[block]; ++m)
            {
                const Push& push = owners.pushes[m];
                if (row_of(push) > largest)
                {
                    largest = row_of(push);
                    const auto& [a, b, c, d] = push.vertex;
                    const std::int32_t owner = owners.repelling[m];
                    const Vec3& at = near_.positions()[a];
                    words = fmt::format(fmt::runtime(of_particles), places_[a], places_[b], places_[c], places_[d]) +
                            fmt::format(": distance {:.4g} mm, repels below {:.4g} mm, at ({:.4g}, {:.4g}, {:.4g}) mm",
                                        owners.closest[0][owner].distance, owners.barrier[owner].gap, at.x, at.y, at.z);
                }
            }
        }
    };
    look(vertices_, "particle {} and the triangle of particles {}, {}, {}");
    look(edges_, "particles {} and {} and the edge of particles {}, {}");
    return words;
}

} // namespace corticle::contact
