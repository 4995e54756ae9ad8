// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/parallel.hpp"
#include "corticle/base/simd.hpp"
#include "corticle/mechanics/contact/owner_blocks.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

// What the pushes of all owners add up to. Of a share of the vertices every rank has all pushes on its own vertices,
// and some others; each push is answered for by one rank.

namespace corticle::contact
{

/// Calls act(place in the lists of pushes, owner) for the pushes of some blocks that this rank answers for.
template <class Pair, class Act>
void SurfaceContact::for_own_pushes(const Owners<Pair>& owners, std::int64_t first, std::int64_t last, Act&& act) const
{
    for (std::int64_t block = first; block < last; ++block)
    {
        const std::int64_t begin = block * owners_at_a_time;
        for (std::int64_t m = begin; m < begin + owners.count[static_cast<std::size_t>(block)]; ++m)
        {
            const std::int32_t owner = owners.repelling[static_cast<std::size_t>(m)];
            if (answers_for(owners, owner))
            {
                act(m, owner);
            }
        }
    }
}

/// How many owners of each block push, of all ranks: blocks of the vertices, then of the edges.
std::vector<std::int64_t> SurfaceContact::count_pushes() const
{
    std::vector<std::int64_t> counts(vertices_.count);
    counts.insert(counts.end(), edges_.count.begin(), edges_.count.end());
    if (!near_.share().is_part())
    {
        return counts;
    }
    struct Count
    {
        std::int32_t block;
        std::int32_t pushes;
    };
    std::vector<Count> own;
    const auto count_of = [&](const auto& owners, std::size_t before)
    {
        for (std::int64_t block = 0; block < std::ssize(owners.count); ++block)
        {
            Count one{static_cast<std::int32_t>(static_cast<std::int64_t>(before) + block), 0};
            for_own_pushes(owners, block, block + 1, [&](std::int64_t, std::int32_t) { ++one.pushes; });
            if (one.pushes > 0)
            {
                own.push_back(one);
            }
        }
    };
    count_of(vertices_, 0);
    count_of(edges_, vertices_.count.size());
    std::ranges::fill(counts, 0);
    for (const Count& one : near_.share().of_all(std::move(own)))
    {
        counts[static_cast<std::size_t>(one.block)] += one.pushes;
    }
    return counts;
}

/// The owner of a push, by its number among those of all ranks.
SurfaceContact::Owner SurfaceContact::middle_of(std::span<const std::int64_t> counts, std::int64_t half) const
{
    std::size_t block = 0;
    std::int64_t before = 0;
    while (before + counts[block] <= half)
    {
        before += counts[block];
        ++block;
    }
    std::vector<std::int64_t> in_block;
    const std::size_t of_vertices = vertices_.count.size();
    const auto list = [&](const auto& owners, std::size_t here, std::int64_t first_owner)
    {
        const auto place = static_cast<std::int64_t>(here);
        for_own_pushes(owners, place, place + 1,
                       [&](std::int64_t, std::int32_t owner) { in_block.push_back(first_owner + owner); });
    };
    block < of_vertices ? list(vertices_, block, 0) : list(edges_, block - of_vertices, std::ssize(vertices_.barrier));
    in_block = near_.share().of_all(std::move(in_block));
    std::ranges::sort(in_block);
    return in_block[static_cast<std::size_t>(half - before)];
}

/// The first push whose owner is not before this one, by its number among owners of its kind.
template <class Pair>
SurfaceContact::Place SurfaceContact::place_of(const Owners<Pair>& owners, Owner owner)
{
    const std::int64_t block = std::clamp<std::int64_t>(owner / owners_at_a_time, 0, std::ssize(owners.count));
    if (owner <= 0 || block == std::ssize(owners.count))
    {
        return {block, 0};
    }
    const auto first = owners.repelling.begin() + block * owners_at_a_time;
    const auto last = first + owners.count[static_cast<std::size_t>(block)];
    return {block, std::lower_bound(first, last, owner) - first};
}

/// Adds the pushes from one to before another up to what acts on each vertex.
template <class Pair>
void SurfaceContact::add_up(const Owners<Pair>& owners, const Place& from, const Place& to, std::vector<Vec3>& loads)
{
    for (std::int64_t block = from.block; block <= to.block && block < std::ssize(owners.count); ++block)
    {
        const Push* pushes = owners.pushes.data() + block * owners_at_a_time;
        const std::int64_t end = block == to.block ? to.number : owners.count[static_cast<std::size_t>(block)];
        for (std::int64_t m = block == from.block ? from.number : 0; m < end; ++m)
        {
            const Lanes force = lanes(pushes[m].force);
            for (std::size_t k = 0; k < 4; ++k)
            {
                const double w = pushes[m].weight[k];
                lanes(loads[pushes[m].vertex[k]]) += Lanes{w, w, w, std::abs(w)} * force;
            }
        }
    }
}

/// Adds the pushes of all ranks up to what acts on each vertex, in two halves.
void SurfaceContact::add_up(std::span<const std::int64_t> counts, std::int64_t active)
{
    const Owner middle = middle_of(counts, active / 2);
    const Place of_vertices = place_of(vertices_, middle);
    const Place of_edges = place_of(edges_, middle - std::ssize(vertices_.barrier));
    parallel_both(
        [&]
        {
            add_up(vertices_, {0, 0}, of_vertices, loads_[0]);
            add_up(edges_, {0, 0}, of_edges, loads_[0]);
        },
        [&]
        {
            add_up(vertices_, of_vertices, {std::ssize(vertices_.count), 0}, loads_[1]);
            add_up(edges_, of_edges, {std::ssize(edges_.count), 0}, loads_[1]);
        });
}

/// Adds what acts on the vertices of the share to the forces, and notes their rates.
void SurfaceContact::give(std::span<Vec3> forces)
{
    const std::span<const std::int32_t> vertices = near_.followed_vertices();
    const SurfaceShare& share = near_.share();
    parallel_runs(BlockLoop{std::ssize(vertices), [&](std::int64_t begin, std::int64_t end)
                            {
                                for (std::int64_t m = begin; m < end; ++m)
                                {
                                    read_soon(&forces[places_[vertices[std::min(m + places_ahead, end - 1)]]]);
                                    const std::int32_t k = vertices[m];
                                    Vec3& first = loads_[0][k];
                                    Vec3& second = loads_[1][k];
                                    if (share.has(k))
                                    {
                                        forces[places_[k]] += first + second;
                                        rate_of_vertex_[k] = (first.lane + second.lane) / masses_[k];
                                    }
                                    first = {};
                                    second = {};
                                }
                            }});
    share.gather(std::span(rate_of_vertex_));
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
                         for_own_pushes(owners, block, block + 1,
                                        [&](std::int64_t m, std::int32_t)
                                        { most = std::max(most, row_of(owners.pushes[static_cast<std::size_t>(m)])); });
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
    return std::sqrt(near_.share().largest(*std::ranges::max_element(largest)));
}

double SurfaceContact::energy() const
{
    struct Repelling
    {
        std::int64_t owner;
        double energy;
    };
    const auto of_owners = [&](const auto& owners)
    {
        std::vector<Repelling> repelling;
        for_own_pushes(owners, 0, std::ssize(owners.count),
                       [&](std::int64_t, std::int32_t owner)
                       {
                           const auto k = static_cast<std::size_t>(owner);
                           repelling.push_back({owner, owners.barrier[k].energy(owners.closest[0][k].distance)});
                       });
        repelling = near_.share().of_all(std::move(repelling));
        std::ranges::sort(repelling, {}, &Repelling::owner);
        return parallel_sum(std::ssize(repelling),
                            [&](std::int64_t k) { return repelling[static_cast<std::size_t>(k)].energy; });
    };
    return of_owners(vertices_) + of_owners(edges_);
}

std::string SurfaceContact::stiffest_pair() const
{
    struct Stiffest
    {
        double row = -1.0;
        std::int64_t of_edges = 0;
        std::int64_t owner = -1;
        std::array<std::int32_t, 4> place{};
        double distance = 0.0;
        double gap = 0.0;
        Vec3 at;
    };
    Stiffest own;
    const auto look = [&](const auto& owners, std::int64_t of_edges)
    {
        for_own_pushes(owners, 0, std::ssize(owners.count),
                       [&](std::int64_t m, std::int32_t owner)
                       {
                           const Push& push = owners.pushes[static_cast<std::size_t>(m)];
                           if (row_of(push) > own.row)
                           {
                               const auto& [a, b, c, d] = push.vertex;
                               own = {row_of(push),
                                      of_edges,
                                      owner,
                                      {places_[a], places_[b], places_[c], places_[d]},
                                      owners.closest[0][owner].distance,
                                      owners.barrier[owner].gap,
                                      near_.positions()[a]};
                           }
                       });
    };
    look(vertices_, 0);
    look(edges_, 1);
    const std::vector<Stiffest> of_ranks = near_.share().of_all(std::vector<Stiffest>{own});
    const Stiffest& stiffest = *std::ranges::min_element(
        of_ranks, {}, [](const Stiffest& one) { return std::tuple(-one.row, one.of_edges, one.owner); });
    const auto& [a, b, c, d] = stiffest.place;
    return (stiffest.of_edges == 0 ? fmt::format("particle {} and the triangle of particles {}, {}, {}", a, b, c, d)
                                   : fmt::format("particles {} and {} and the edge of particles {}, {}", a, b, c, d)) +
           fmt::format(": distance {:.4g} mm, repels below {:.4g} mm, at ({:.4g}, {:.4g}, {:.4g}) mm",
                       stiffest.distance, stiffest.gap, stiffest.at.x, stiffest.at.y, stiffest.at.z);
}

} // namespace corticle::contact
