// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

// What pairs contribute to F and to the forces, and what the sums over the neighbours of one particle (pair_sums.hpp)
// give. Neither threads nor materials are known here. Symbols as in docs/theory/tlsph.md.
//
// Both sums are of differences X_j - X_i and x_j - x_i. Multiplied out, what depends on i leaves the sum, and what is
// left, sum_j w_ij (thirteen numbers of j), needs no arithmetic on pairs but the multiplication with the weight. A
// prime marks positions relative to an origin close by (that of the block), so that no digits are lost.

namespace corticle::tlsph
{

/// What one neighbour contributes, or a sum of such: two SIMD registers of eight doubles.
template <RealLike Real>
struct alignas(64) BasicPairTerms
{
    BasicMat3<Real> matrix;
    BasicVec3<Real> vector; ///< its fourth lane holds a scalar of its own
};
using PairTerms = BasicPairTerms<double>;

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
            sum.vector.lane - ScalarOf<Real>(2.0) * dot(x, sum.vector) + weighted_sum.lane * squared_norm(x)};
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

} // namespace corticle::tlsph
