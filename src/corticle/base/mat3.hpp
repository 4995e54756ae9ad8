// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

namespace corticle
{

/// A 3x3 matrix stored by columns: `column[j][i]` is row i, column j.
struct Mat3
{
    Vec3 column[3];

    constexpr double& operator()(int row, int col) { return column[col][row]; }
    constexpr double operator()(int row, int col) const { return column[col][row]; }

    static constexpr Mat3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
    static constexpr Mat3 diagonal(double a, double b, double c) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}; }
};

constexpr Vec3 operator*(const Mat3& a, const Vec3& v)
{
    return v.x * a.column[0] + v.y * a.column[1] + v.z * a.column[2];
}
constexpr Mat3 operator*(const Mat3& a, const Mat3& b)
{
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
}
constexpr Mat3 operator*(double s, const Mat3& a)
{
    return {{s * a.column[0], s * a.column[1], s * a.column[2]}};
}
constexpr Mat3 operator+(const Mat3& a, const Mat3& b)
{
    return {{a.column[0] + b.column[0], a.column[1] + b.column[1], a.column[2] + b.column[2]}};
}
constexpr Mat3 operator-(const Mat3& a, const Mat3& b)
{
    return a + (-1.0) * b;
}
constexpr Mat3& operator+=(Mat3& a, const Mat3& b)
{
    return a = a + b;
}

/// a b^T
constexpr Mat3 outer(const Vec3& a, const Vec3& b)
{
    return {{b.x * a, b.y * a, b.z * a}};
}
constexpr Mat3 transpose(const Mat3& a)
{
    return {{{a.column[0].x, a.column[1].x, a.column[2].x},
             {a.column[0].y, a.column[1].y, a.column[2].y},
             {a.column[0].z, a.column[1].z, a.column[2].z}}};
}
constexpr double trace(const Mat3& a)
{
    return a.column[0].x + a.column[1].y + a.column[2].z;
}
constexpr double determinant(const Mat3& a)
{
    return dot(a.column[0], cross(a.column[1], a.column[2]));
}
/// det(a) a^-T: its columns are the cross products of the columns of a.
constexpr Mat3 cofactor(const Mat3& a)
{
    return {{cross(a.column[1], a.column[2]), cross(a.column[2], a.column[0]), cross(a.column[0], a.column[1])}};
}
/// a^-1; not finite where a is singular.
constexpr Mat3 inverse(const Mat3& a)
{
    return (1.0 / determinant(a)) * transpose(cofactor(a));
}
/// sum_ij a_ij b_ij
constexpr double contract(const Mat3& a, const Mat3& b)
{
    return dot(a.column[0], b.column[0]) + dot(a.column[1], b.column[1]) + dot(a.column[2], b.column[2]);
}

} // namespace corticle
