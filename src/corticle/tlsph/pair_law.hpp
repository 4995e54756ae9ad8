// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"
#include "corticle/base/mat3.hpp"

#include <cstdint>

// What pairs contribute to F and to the forces, and the sum over the neighbours of one particle. They know neither
// threads nor materials. Symbols as in docs/theory/tlsph.md.
//
// Both sums are of differences X_j - X_i and x_j - x_i. Multiplied out, what depends on i leaves the sum, and what is
// left, sum_j w_ij (thirteen numbers of j), needs no arithmetic on pairs but the multiplication with the weight. A
// prime marks positions relative to an origin close by (that of the block), so that no digits are lost.

namespace corticle
{

/// What one neighbour contributes, or a sum of such: two SIMD registers of eight doubles.
template <RealLike Real>
struct alignas(64) BasicPairTerms
{
    BasicMat3<Real> matrix;
    BasicVec3<Real> vector; ///< its fourth lane holds a scalar of its own
};
using PairTerms = BasicPairTerms<double>;

/// The neighbours j of one particle i.
struct NeighborRange
{
    const std::uint16_t* place; ///< of j in the table of terms
    const float* weight;        ///< w_ij
    std::int64_t count;
};

/// How far ahead of the pair at hand weights and places are asked for: their lists follow one another in memory.
inline constexpr std::int64_t pairs_ahead = 256;

/// sum_j w_ij terms_j
CORTICLE_INLINE void sum_terms(const NeighborRange& neighbors, const PairTerms* terms, PairTerms& sum)
{
    // Four pairs of sums, not one: each waits only for its own last addition.
    constexpr std::int64_t stride = 4;
    WideLanes low[stride]{};
    WideLanes high[stride]{};
    const auto add = [&](std::int64_t s, double w, const PairTerms& term)
    {
        const auto* lanes = reinterpret_cast<const WideMemory*>(&term);
        low[s] += w * lanes[0];
        high[s] += w * lanes[1];
    };
    std::int64_t k = 0;
    for (; k + wide_lanes <= neighbors.count; k += wide_lanes)
    {
        // Through memory: a load spreads a number over all lanes, which is cheaper than to move it out of one.
        alignas(64) double w[wide_lanes];
        read_soon(neighbors.weight + k + pairs_ahead);
        read_soon(neighbors.place + k + pairs_ahead);
        *reinterpret_cast<WideMemory*>(w) = widen(neighbors.weight + k);
        for (std::int64_t m = 0; m < wide_lanes; ++m)
        {
            add(m % stride, w[m], terms[neighbors.place[k + m]]);
        }
    }
    for (; k < neighbors.count; ++k)
    {
        add(0, static_cast<double>(neighbors.weight[k]), terms[neighbors.place[k]]);
    }
    auto* result = reinterpret_cast<WideMemory*>(&sum);
    result[0] = (low[0] + low[1]) + (low[2] + low[3]);
    result[1] = (high[0] + high[1]) + (high[2] + high[3]);
}

/// What particle j contributes to F of its neighbours: x' X'^T, x' and |x'|².
CORTICLE_INLINE PairTerms deformation_terms(const Vec3& X, const Vec3& x)
{
    PairTerms terms{outer(x, X), x};
    terms.vector.lane = squared_norm(x);
    return terms;
}

/// What the deformation pass needs of the pairs of one particle.
template <RealLike Real>
struct DeformationSums
{
    BasicMat3<Real> moment;       ///< sum_j w_ij x_ij X_ij^T; times L_i it is F_i
    BasicVec3<Real> weighted_sum; ///< sum_j w_ij x_ij
    Real squared_lengths;         ///< sum_j w_ij |x_ij|²
};

/// @param sum  of the deformation_terms of the neighbours of i   @param X,x  X_i', x_i'
/// @param weighted_sum  b_i = sum_j w_ij X_ij; its fourth lane holds sum_j w_ij
template <RealLike Real>
CORTICLE_INLINE DeformationSums<Real> deformation_sums(const BasicPairTerms<Real>& sum, const BasicVec3<Real>& X,
                                                       const BasicVec3<Real>& x, const BasicVec3<Real>& weighted_sum)
{
    return {sum.matrix - outer(sum.vector, X) - outer(x, weighted_sum), sum.vector - weighted_sum.lane * x,
            sum.vector.lane - 2.0 * dot(x, sum.vector) + weighted_sum.lane * squared_norm(x)};
}

/// What the force pass reads of a neighbour: two cache lines.
struct alignas(64) ForceRecord
{
    Mat3 M; ///< V_i P_i L_i - zeta_i F_i
    Vec3 x; ///< current position [mm]; its fourth lane holds zeta_i
};

/// What particle j contributes to the force on its neighbours: M_j, M_j X_j' + zeta_j x_j' and zeta_j.
CORTICLE_INLINE PairTerms force_terms(const Mat3& M, double zeta, const Vec3& X, const Vec3& x)
{
    PairTerms terms{M, M * X + zeta * x};
    terms.vector.lane = zeta;
    return terms;
}

/// sum_j w_ij (M_j X_ij + zeta_j x_ij), the part of the force on particle i that its neighbours' states make.
/// @param sum  of their force_terms   @param X,x  X_i', x_i'
CORTICLE_INLINE Vec3 neighbors_force(const PairTerms& sum, const Vec3& X, const Vec3& x)
{
    return sum.vector - sum.matrix * X - sum.vector.lane * x;
}

} // namespace corticle
