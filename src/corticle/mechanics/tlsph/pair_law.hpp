// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

// What pairs contribute to F and to the forces, and what the sums over the neighbours of one particle (pair_sums.hpp)
// give. Neither threads nor materials are known here. Symbols as in docs/theory/tlsph.md.
//
// Both sums are of differences X_j - X_i and x_j - x_i. Multiplied out, what depends on i leaves the sum, and what is
// left, sum_j w_ij (thirteen numbers of j), needs no arithmetic on pairs but the multiplication with the weight. A
// prime marks positions relative to an origin close by (that of the block), so that no digits are lost.
//
// Near the surface the gradient knows one more function, (n_i . X_ij) X_ij (enriched_gradient.hpp). Multiplied out, it
// takes the products of X_j' with itself, eighteen numbers more.

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

/// What it contributes besides where gradients are enriched, a third-order tensor T_abc = T_acb: two registers more.
template <RealLike Real>
struct alignas(64) BasicProductTerms
{
    BasicVec3<Real> column[4]; ///< T_axx, T_axy, T_axz, T_ayy; the fourth lanes of the first three hold T_ayz, those of
                               ///< BasicPairTerms::matrix T_azz
};
using ProductTerms = BasicProductTerms<double>;

/// Both.
template <RealLike Real>
struct BasicEnrichedTerms
{
    BasicPairTerms<Real> linear;
    BasicProductTerms<Real> products;
};
using EnrichedTerms = BasicEnrichedTerms<double>;

/// Writes T_abc = (A_ab v_c + A_ac v_b) / 2.
CORTICLE_INLINE void set_products(const Mat3& A, const Vec3& v, PairTerms& linear, ProductTerms& products)
{
    const auto& [a_x, a_y, a_z] = A.column;
    const Vec3 yz = 0.5 * (v.z * a_y + v.y * a_z);
    const Vec3 zz = v.z * a_z;
    products.column[0] = v.x * a_x;
    products.column[1] = 0.5 * (v.y * a_x + v.x * a_y);
    products.column[2] = 0.5 * (v.z * a_x + v.x * a_z);
    products.column[3] = v.y * a_y;
    for (int axis = 0; axis < 3; ++axis)
    {
        products.column[axis].lane = yz[axis];
        linear.matrix.column[axis].lane = zz[axis];
    }
}

/// sum_c T_abc v_c
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> contract_products(const BasicEnrichedTerms<Real>& terms, const BasicVec3<Real>& v)
{
    const auto& [xx, xy, xz, yy] = terms.products.column;
    const auto& m = terms.linear.matrix.column;
    const BasicVec3<Real> yz{xx.lane, xy.lane, xz.lane};
    const BasicVec3<Real> zz{m[0].lane, m[1].lane, m[2].lane};
    return {{v.x * xx + v.y * xy + v.z * xz, v.x * xy + v.y * yy + v.z * yz, v.x * xz + v.y * yz + v.z * zz}};
}

/// What particle j contributes to F of its neighbours: x' X'^T, x' and |x'|².
CORTICLE_INLINE PairTerms deformation_terms(const Vec3& X, const Vec3& x)
{
    PairTerms terms{outer(x, X), x};
    terms.vector.lane = squared_norm(x);
    return terms;
}

/// x'_a X'_b X'_c besides. @param linear  the deformation_terms
CORTICLE_INLINE void set_deformation_products(const Vec3& X, PairTerms& linear, ProductTerms& products)
{
    set_products(linear.matrix, X, linear, products);
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

/// sum_j w_ij (n_i . X_ij) x_ij X_ij^T
/// @param moment  sum_j w_ij (n_i . X_ij) X_ij   @param n  n_i   The others as above.
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> enriched_moment(const BasicEnrichedTerms<Real>& sum, const BasicVec3<Real>& X,
                                                const BasicVec3<Real>& x, const BasicVec3<Real>& n,
                                                const BasicVec3<Real>& moment)
{
    const BasicMat3<Real>& T = sum.linear.matrix;
    const Real height = dot(n, X);
    return contract_products(sum, n) - height * (T - outer(sum.linear.vector, X)) - outer(T * n, X) - outer(x, moment);
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

/// What an enriched particle contributes, with R_j = V_j P_j Q_j: M_j - (n_j . X_j') R_j - R_j X_j' n_j^T in place of
/// M_j, M_j X_j' + zeta_j x_j' - (n_j . X_j') R_j X_j', zeta_j, and R_j n_j as products.
/// @param R  its fourth lanes hold n_j   @param linear  in: the force_terms
CORTICLE_INLINE void enrich_force_terms(const Mat3& R, const Vec3& X, PairTerms& linear, ProductTerms& products)
{
    const Vec3 n{R.column[0].lane, R.column[1].lane, R.column[2].lane};
    const double height = dot(n, X);
    const Vec3 R_X = R * X;
    const double zeta = linear.vector.lane;
    linear.matrix = linear.matrix - height * R - outer(R_X, n);
    linear.vector -= height * R_X;
    linear.vector.lane = zeta;
    set_products(R, n, linear, products);
}

/// sum_j w_ij (M_j X_ij + zeta_j x_ij), the part of the force on particle i that its neighbours' states make.
/// @param sum  of their force_terms   @param X,x  X_i', x_i'
CORTICLE_INLINE Vec3 neighbors_force(const PairTerms& sum, const Vec3& X, const Vec3& x)
{
    return sum.vector - sum.matrix * X - sum.vector.lane * x;
}

/// sum_j w_ij (M_j X_ij + zeta_j x_ij - (n_j . X_ij) R_j X_ij)
CORTICLE_INLINE Vec3 neighbors_force(const EnrichedTerms& sum, const Vec3& X, const Vec3& x)
{
    return neighbors_force(sum.linear, X, x) - contract_products(sum, X) * X;
}

} // namespace corticle::tlsph
