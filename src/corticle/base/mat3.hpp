// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

namespace corticle
{

/// A 3x3 matrix stored by columns: `column[j][i]` is row i, column j.
template <RealLike Real>
struct BasicMat3
{
    BasicVec3<Real> column[3];

    CORTICLE_INLINE constexpr Real& operator()(int row, int col) { return column[col][row]; }
    CORTICLE_INLINE constexpr const Real& operator()(int row, int col) const { return column[col][row]; }

    CORTICLE_INLINE static constexpr BasicMat3 identity()
    {
        const Real one = broadcast<Real>(1.0);
        return diagonal(one, one, one);
    }
    CORTICLE_INLINE static constexpr BasicMat3 diagonal(const Real& a, const Real& b, const Real& c)
    {
        const Real zero{};
        return {{{a, zero, zero}, {zero, b, zero}, {zero, zero, c}}};
    }
};
using Mat3 = BasicMat3<double>;

template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real> operator*(const BasicMat3<Real>& a, const BasicVec3<Real>& v)
{
    return v.x * a.column[0] + v.y * a.column[1] + v.z * a.column[2];
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> operator*(const BasicMat3<Real>& a, const BasicMat3<Real>& b)
{
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
}
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr BasicMat3<Real> operator*(const Factor& s, const BasicMat3<Real>& a)
{
    return {{s * a.column[0], s * a.column[1], s * a.column[2]}};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> operator+(const BasicMat3<Real>& a, const BasicMat3<Real>& b)
{
    return {{a.column[0] + b.column[0], a.column[1] + b.column[1], a.column[2] + b.column[2]}};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> operator-(const BasicMat3<Real>& a, const BasicMat3<Real>& b)
{
    return a + (-1.0) * b;
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real>& operator+=(BasicMat3<Real>& a, const BasicMat3<Real>& b)
{
    return a = a + b;
}

/// a b^T
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> outer(const BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return {{b.x * a, b.y * a, b.z * a}};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> transpose(const BasicMat3<Real>& a)
{
    return {{{a.column[0].x, a.column[1].x, a.column[2].x},
             {a.column[0].y, a.column[1].y, a.column[2].y},
             {a.column[0].z, a.column[1].z, a.column[2].z}}};
}
template <RealLike Real>
CORTICLE_INLINE constexpr Real trace(const BasicMat3<Real>& a)
{
    return a.column[0].x + a.column[1].y + a.column[2].z;
}
template <RealLike Real>
CORTICLE_INLINE constexpr Real determinant(const BasicMat3<Real>& a)
{
    return dot(a.column[0], cross(a.column[1], a.column[2]));
}
/// det(a) a^-T: its columns are the cross products of the columns of a.
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> cofactor(const BasicMat3<Real>& a)
{
    return {{cross(a.column[1], a.column[2]), cross(a.column[2], a.column[0]), cross(a.column[0], a.column[1])}};
}
/// a^-1; not finite where a is singular.
template <RealLike Real>
CORTICLE_INLINE constexpr BasicMat3<Real> inverse(const BasicMat3<Real>& a)
{
    return (ScalarOf<Real>(1.0) / determinant(a)) * transpose(cofactor(a));
}
/// sum_ij a_ij b_ij
template <RealLike Real>
CORTICLE_INLINE constexpr Real contract(const BasicMat3<Real>& a, const BasicMat3<Real>& b)
{
    return dot(a.column[0], b.column[0]) + dot(a.column[1], b.column[1]) + dot(a.column[2], b.column[2]);
}

} // namespace corticle
