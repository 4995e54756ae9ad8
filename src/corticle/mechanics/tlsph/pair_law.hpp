// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/fixed_array.hpp"
#include "corticle/base/mat3.hpp"

// What pairs contribute to F and to the forces, and what the sums over the neighbours of one particle (pair_sums.hpp)
// give. Neither threads nor materials are known here. Symbols as in docs/theory/tlsph.md.
//
// Both sums are of differences X_j - X_i and x_j - x_i. Multiplied out, what depends on i leaves the sum, and what is
// left, sum_j w_ij (thirteen numbers of j), needs no arithmetic on pairs but the multiplication with the weight. A
// prime marks positions relative to an origin close by (that of the block), so that no digits are lost.
//
// Near the surface fits are quadratic (fit.hpp). Multiplied out, the products of X_ij with itself take those of X_j',
// eighteen numbers more.

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

/// sum_c T_abc v_c. @param zz  T_azz
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> contract_products(const BasicProductTerms<Real>& T, const BasicVec3<Real>& zz,
                                                  const BasicVec3<Real>& v)
{
    const auto& [xx, xy, xz, yy] = T.column;
    const BasicVec3<Real> yz{xx.lane, xy.lane, xz.lane};
    return {{v.x * xx + v.y * xy + v.z * xz, v.x * xy + v.y * yy + v.z * yz, v.x * xz + v.y * yz + v.z * zz}};
}

/// The fourth lanes of the columns.
template <RealLike Real>
CORTICLE_INLINE BasicVec3<Real> lanes_of(const BasicMat3<Real>& m)
{
    return {m.column[0].lane, m.column[1].lane, m.column[2].lane};
}
template <RealLike Real>
CORTICLE_INLINE void set_lanes(const BasicVec3<Real>& lanes, BasicMat3<Real>& m)
{
    m.column[0].lane = lanes.x;
    m.column[1].lane = lanes.y;
    m.column[2].lane = lanes.z;
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
    const auto [a_x, a_y, a_z] = linear.matrix.column;
    products.column[0] = X.x * a_x;
    products.column[1] = X.y * a_x;
    products.column[2] = X.z * a_x;
    products.column[3] = X.y * a_y;
    const Vec3 yz = X.z * a_y;
    products.column[0].lane = yz.x;
    products.column[1].lane = yz.y;
    products.column[2].lane = yz.z;
    set_lanes(X.z * a_z, linear.matrix);
}

/// What the deformation pass needs of the pairs of one particle.
template <RealLike Real>
struct DeformationSums
{
    BasicMat3<Real> moment;       ///< sum_j w_ij x_ij X_ij^T
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

/// sum_j w_ij x_ij (X_ij)_b (X_ij)_c for bc = xx, xy, xz, yy, yz, zz
/// @param second_moment  sum_j w_ij (X_ij)_b (X_ij)_c, in the same order   The others as above.
template <RealLike Real>
CORTICLE_INLINE FixedArray<BasicVec3<Real>, 6> product_moments(const BasicEnrichedTerms<Real>& sum,
                                                               const BasicVec3<Real>& X, const BasicVec3<Real>& x,
                                                               const FixedArray<Real, 6>& second_moment)
{
    const auto& [a_x, a_y, a_z] = sum.linear.matrix.column;
    const auto& [xx, xy, xz, yy] = sum.products.column;
    const BasicVec3<Real> s_x = X.x * sum.linear.vector - a_x;
    const BasicVec3<Real> s_y = X.y * sum.linear.vector - a_y;
    const BasicVec3<Real> s_z = X.z * sum.linear.vector - a_z;
    return {xx + X.x * (s_x - a_x) - second_moment[0] * x,
            xy + X.y * s_x - X.x * a_y - second_moment[1] * x,
            xz + X.z * s_x - X.x * a_z - second_moment[2] * x,
            yy + X.y * (s_y - a_y) - second_moment[3] * x,
            lanes_of(BasicMat3<Real>{{xx, xy, xz}}) + X.z * s_y - X.y * a_z - second_moment[4] * x,
            lanes_of(sum.linear.matrix) + X.z * (s_z - a_z) - second_moment[5] * x};
}

/// What the force pass reads of a neighbour: two cache lines.
struct alignas(64) ForceRecord
{
    Mat3 M; ///< Z_i of the coordinates (fit.hpp); the fourth lanes hold T_azz where the fit is quadratic
    Vec3 x; ///< current position [mm]; its fourth lane holds zeta_i
};

/// What particle j contributes to the force on its neighbours: M_j, M_j X_j' + zeta_j x_j' and zeta_j.
CORTICLE_INLINE PairTerms force_terms(const Mat3& M, double zeta, const Vec3& X, const Vec3& x)
{
    PairTerms terms{M, M * X + zeta * x};
    terms.vector.lane = zeta;
    return terms;
}

/// What a particle with a quadratic fit contributes. With T_abc X_b X_c its pull by products: M_j - 2 T_j X_j' in place
/// of M_j, M_j X_j' + zeta_j x_j' - T_j X_j' X_j', zeta_j, and T_j.
/// @param T  T_j, but for T_azz, which is in the lanes of M   @param linear  in: the force_terms
CORTICLE_INLINE void enrich_force_terms(const ProductTerms& T, const Mat3& M, const Vec3& X, PairTerms& linear,
                                        ProductTerms& products)
{
    const Vec3 zz = lanes_of(M);
    const Mat3 T_X = contract_products(T, zz, X);
    const double zeta = linear.vector.lane;
    linear.matrix = linear.matrix - 2.0 * T_X;
    set_lanes(zz, linear.matrix);
    linear.vector -= T_X * X;
    linear.vector.lane = zeta;
    products = T;
}

/// sum_j w_ij (M_j X_ij + zeta_j x_ij), the part of the force on particle i that its neighbours' states make.
/// @param sum  of their force_terms   @param X,x  X_i', x_i'
CORTICLE_INLINE Vec3 neighbors_force(const PairTerms& sum, const Vec3& X, const Vec3& x)
{
    return sum.vector - sum.matrix * X - sum.vector.lane * x;
}

/// sum_j w_ij (M_j X_ij + zeta_j x_ij - T_j X_ij X_ij)
CORTICLE_INLINE Vec3 neighbors_force(const EnrichedTerms& sum, const Vec3& X, const Vec3& x)
{
    return neighbors_force(sum.linear, X, x) - contract_products(sum.products, lanes_of(sum.linear.matrix), X) * X;
}

} // namespace corticle::tlsph
