// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace corticle
{

/// A vector of three doubles, aligned to 32 bytes so that one load brings it into a SIMD register.
struct alignas(32) Vec3
{
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double lane = 0.0; ///< fills the register; stays zero

    constexpr double& operator[](int axis) { return axis == 0 ? x : (axis == 1 ? y : z); }
    constexpr double operator[](int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
    friend constexpr bool operator==(const Vec3& a, const Vec3& b) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a)
{
    return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(double s, const Vec3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec3 operator*(const Vec3& a, double s)
{
    return s * a;
}
constexpr Vec3 operator/(const Vec3& a, double s)
{
    return {a.x / s, a.y / s, a.z / s};
}
constexpr Vec3& operator+=(Vec3& a, const Vec3& b)
{
    return a = a + b;
}
constexpr Vec3& operator-=(Vec3& a, const Vec3& b)
{
    return a = a - b;
}
constexpr Vec3& operator*=(Vec3& a, double s)
{
    return a = s * a;
}

constexpr double dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_norm(const Vec3& a)
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
