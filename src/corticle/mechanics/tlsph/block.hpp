// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/wide_group.hpp"
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

CORTICLE_INLINE void fill_deformation_terms(const Block& block, const Vec3* x, std::vector<PairTerms>& terms)
{
    const auto table = block.table();
    terms.resize(table.size());
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const std::int32_t soon = ahead_of(table, m);
        read_soon(&block.particles.X[soon]);
        read_soon(&x[soon]);
        terms[m] = deformation_terms(block.particles.X[j] - block.X_origin, x[j] - block.x_origin);
    }
}

CORTICLE_INLINE DeformationSums<double> sum_deformation(const Block& block, const Vec3* x, std::int64_t i,
                                                        const std::vector<PairTerms>& terms)
{
    PairTerms sum;
    sum_terms(block.particles.pairs, i, terms.data(), sum);
    return deformation_sums(sum, block.particles.X[i] - block.X_origin, x[i] - block.x_origin,
                            block.particles.weighted_sum[i]);
}

CORTICLE_INLINE WideVec3 gather(const WideGroup& group, const Vec3* values)
{
    return group.gather_vectors([&](std::int64_t i) -> const Vec3& { return values[i]; });
}

/// The same for eight particles.
CORTICLE_INLINE DeformationSums<WideLanes> sum_deformation(const Block& block, const Vec3* x, const WideGroup& group,
                                                           const std::vector<PairTerms>& terms)
{
    PairTerms sums[wide_lanes];
    for (std::int64_t lane = 0; lane < group.count; ++lane)
    {
        sum_terms(block.particles.pairs, group.first + lane, terms.data(), sums[lane]);
    }
    const WideGroup among{0, group.count};
    const BasicPairTerms<WideLanes> sum{
        among.gather_matrices([&](std::int64_t i) -> const Mat3& { return sums[i].matrix; }),
        among.gather_vectors([&](std::int64_t i) -> const Vec3& { return sums[i].vector; })};
    return deformation_sums(sum, gather(group, block.particles.X.data()) - broadcast(block.X_origin),
                            gather(group, x) - broadcast(block.x_origin),
                            gather(group, block.particles.weighted_sum.data()));
}

} // namespace corticle::tlsph
