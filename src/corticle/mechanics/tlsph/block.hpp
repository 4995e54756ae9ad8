// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/wide_group.hpp"
#include "corticle/mechanics/tlsph/fit.hpp"
#include "corticle/mechanics/tlsph/pair_sums.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <algorithm>
#include <span>
#include <vector>

// How the passes over a block of particles read positions and sum over pairs.

namespace corticle::tlsph
{

/// A block of particles: its place in the pairs, and the origin of its primed positions.
struct Block
{
    const Particles& particles;
    std::int64_t begin; ///< first particle
    std::int64_t end;
    Vec3 X_origin;
    Vec3 x_origin;

    /// How far enriched gradients reach into the block.
    EnrichedGradients::Reach farthest() const { return particles.enriched.farthest(begin, end); }

    std::span<const std::int32_t> table() const { return particles.pairs.table_of(begin / particles.pairs.block_size); }
};

inline Block block_of(const Particles& particles, std::span<const Vec3> x, std::int64_t begin, std::int64_t end)
{
    const std::int64_t middle = begin + (end - begin) / 2;
    return {particles, begin, end, particles.X[middle], x[middle]};
}

/// The particle some rows of a table further on, to be asked for now.
CORTICLE_INLINE std::int32_t ahead_of(std::span<const std::int32_t> table, std::size_t row)
{
    constexpr std::size_t rows_ahead = 32;
    return table[std::min(row + rows_ahead, table.size() - 1)];
}

/// Writes what the particles in the table of a block contribute to the deformation of its own.
CORTICLE_INLINE void fill_deformation_terms(const Block& block, const Vec3* x, BlockTerms& terms)
{
    const auto table = block.table();
    const EnrichedGradients& enriched = block.particles.enriched;
    const bool has_products = block.farthest() == EnrichedGradients::Reach::itself;
    terms.linear.resize(table.size());
    terms.products.resize(has_products ? table.size() : 0);
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const std::int32_t soon = ahead_of(table, m);
        read_soon(&block.particles.X[soon]);
        read_soon(&x[soon]);
        const Vec3 X = block.particles.X[j] - block.X_origin;
        terms.linear[m] = deformation_terms(X, x[j] - block.x_origin);
        if (has_products && enriched.reach[j] != EnrichedGradients::Reach::none)
        {
            set_deformation_products(X, terms.linear[m], terms.products[m]);
        }
    }
}

CORTICLE_INLINE WideVec3 gather(const WideGroup& group, const Vec3* values)
{
    return group.gather_vectors([&](std::int64_t i) -> const Vec3& { return values[i]; });
}

using LinearFit = Fit<WideLanes, linear_functions>;
using QuadraticFit = Fit<WideLanes, quadratic_functions>;

/// Fits of eight particles, all of them linear.
CORTICLE_INLINE LinearFit linear_fit(const Block& block, const Vec3* x, const WideGroup& group, const BlockTerms& terms)
{
    const Particles& particles = block.particles;
    PairTerms sums[wide_lanes];
    for (std::int64_t lane = 0; lane < group.count; ++lane)
    {
        sum_terms(particles.pairs, group.first + lane, terms, sums[lane]);
    }
    const WideGroup among{0, group.count};
    const BasicPairTerms<WideLanes> sum{
        among.gather_matrices([&](std::int64_t i) -> const Mat3& { return sums[i].matrix; }),
        among.gather_vectors([&](std::int64_t i) -> const Vec3& { return sums[i].vector; })};
    const WideMat3 L = group.gather_matrices([&](std::int64_t i) -> const Mat3& { return particles.correction[i]; });
    const WideVec3 b = gather(group, particles.weighted_sum.data());
    const auto moments = deformation_sums(sum, gather(group, particles.X.data()) - broadcast(block.X_origin),
                                          gather(group, x) - broadcast(block.x_origin), b);
    const auto& [l_x, l_y, l_z] = L.column;
    return {{l_x.x, l_y.x, l_z.x, l_y.y, l_z.y, l_z.z},
            {b.x, b.y, b.z},
            {},
            {moments.moment.column[0], moments.moment.column[1], moments.moment.column[2]},
            moments.weighted_sum,
            moments.squared_lengths};
}

/// Fits of eight particles of which at least one is quadratic.
CORTICLE_INLINE QuadraticFit quadratic_fit(const Block& block, const Vec3* x, const WideGroup& group,
                                           const BlockTerms& terms)
{
    const Particles& particles = block.particles;
    const EnrichedGradients& enriched = particles.enriched;
    EnrichedTerms sums[wide_lanes];
    for (std::int64_t lane = 0; lane < group.count; ++lane)
    {
        const std::int64_t i = group.first + lane;
        enriched.reach[i] == EnrichedGradients::Reach::itself
            ? sum_terms(particles.pairs, i, particles.pairs.begin[i + 1], terms, sums[lane])
            : sum_terms(particles.pairs, i, terms, sums[lane].linear);
    }
    const WideGroup among{0, group.count};
    BasicEnrichedTerms<WideLanes> sum;
    sum.linear = {among.gather_matrices([&](std::int64_t i) -> const Mat3& { return sums[i].linear.matrix; }),
                  among.gather_vectors([&](std::int64_t i) -> const Vec3& { return sums[i].linear.vector; })};
    for (int p = 0; p < 4; ++p)
    {
        sum.products.column[p] =
            among.gather_vectors([&](std::int64_t i) -> const Vec3& { return sums[i].products.column[p]; });
    }
    const QuadraticFits& fits = enriched.fits[enriched.group[group.first / wide_lanes]];
    const auto& K = fits.second_moment;
    const WideVec3 b = gather(group, particles.weighted_sum.data());
    const WideVec3 X = gather(group, particles.X.data()) - broadcast(block.X_origin);
    const WideVec3 now = gather(group, x) - broadcast(block.x_origin);
    const auto moments = deformation_sums(sum.linear, X, now, b);
    const auto& [m_x, m_y, m_z] = moments.moment.column;
    const auto H = product_moments(sum, X, now, K);
    return {fits.inverse,
            {b.x, b.y, b.z, K[0], K[1], K[2], K[3], K[4], K[5]},
            fits.at,
            {m_x, m_y, m_z, H[0], H[1], H[2], H[3], H[4], H[5]},
            moments.weighted_sum,
            moments.squared_lengths};
}

} // namespace corticle::tlsph
