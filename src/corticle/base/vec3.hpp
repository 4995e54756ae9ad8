// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"

#include <cmath>

namespace corticle
{

/// A vector of three numbers. Those of doubles are aligned to 32 bytes, so that one load brings one into a SIMD
/// register.
template <RealLike Real>
struct alignas(sizeof(Real) == sizeof(double) ? 32 : alignof(Real)) BasicVec3
{
    Real x{};
    Real y{};
    Real z{};
    Real lane{}; ///< fills the register; zero, or a number that belongs to the vector

    CORTICLE_INLINE constexpr Real& operator[](int axis) { return axis == 0 ? x : (axis == 1 ? y : z); }
    CORTICLE_INLINE constexpr const Real& operator[](int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
    /// Compares the three numbers: the fourth lane is not part of the vector.
    CORTICLE_INLINE friend constexpr bool operator==(const BasicVec3& a, const BasicVec3& b)
    {
        return a.x == b.x && a.y == b.y && a.z == b.z;
    }
};
using Vec3 = BasicVec3<double>;

/// A factor that a vector of Real can be multiplied with.
template <class Factor, class Real>
concept FactorOf = std::same_as<Factor, Real> || std::integral<Factor> || std::floating_point<Factor>;

/// The factor as the arithmetic of Real takes it: in single precision where Real is.
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr auto factor_of(const Factor& s)
{
    if constexpr (std::same_as<Factor, Real>)
    {
        return s;
    }
    else
    {
        return static_cast<ScalarOf<Real>>(s);
    }
}

template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real> operator+(const BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real> operator-(const BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real> operator-(const BasicVec3<Real>& a)
{
    return {-a.x, -a.y, -a.z};
}
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr BasicVec3<Real> operator*(const Factor& s, const BasicVec3<Real>& a)
{
    const auto f = factor_of<Real>(s);
    return {f * a.x, f * a.y, f * a.z};
}
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr BasicVec3<Real> operator*(const BasicVec3<Real>& a, const Factor& s)
{
    return s * a;
}
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr BasicVec3<Real> operator/(const BasicVec3<Real>& a, const Factor& s)
{
    const auto f = factor_of<Real>(s);
    return {a.x / f, a.y / f, a.z / f};
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real>& operator+=(BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return a = a + b;
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real>& operator-=(BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return a = a - b;
}
template <RealLike Real, FactorOf<Real> Factor>
CORTICLE_INLINE constexpr BasicVec3<Real>& operator*=(BasicVec3<Real>& a, const Factor& s)
{
    return a = s * a;
}

template <RealLike Real>
CORTICLE_INLINE constexpr Real dot(const BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <RealLike Real>
CORTICLE_INLINE constexpr BasicVec3<Real> cross(const BasicVec3<Real>& a, const BasicVec3<Real>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <RealLike Real>
CORTICLE_INLINE constexpr Real squared_norm(const BasicVec3<Real>& a)
{
    return dot(a, a);
}
inline double norm(const Vec3& a)
{
    return std::sqrt(dot(a, a));
}
/// a / |a|; the zero vector stays zero.
inline Vec3 normalized(const Vec3& a)
{
    const double length = norm(a);
    return length > 0.0 ? a / length : Vec3{};
}
inline bool is_finite(const Vec3& a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace corticle
