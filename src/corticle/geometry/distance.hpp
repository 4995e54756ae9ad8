// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <algorithm>
#include <array>

namespace corticle
{

/// Barycentric weights of the point of triangle abc closest to p (Ericson 2005, section 5.1.5).
inline std::array<double, 3> closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = dot(ab, p - a);
    const double d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0)
    {
        return {1.0, 0.0, 0.0};
    }
    const double d3 = dot(ab, p - b);
    const double d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3)
    {
        return {0.0, 1.0, 0.0};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    {
        const double s = d1 / (d1 - d3);
        return {1.0 - s, s, 0.0};
    }
    const double d5 = dot(ab, p - c);
    const double d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6)
    {
        return {0.0, 0.0, 1.0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    {
        const double s = d2 / (d2 - d6);
        return {1.0 - s, 0.0, s};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    {
        const double s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - s, s};
    }
    const double sum = va + vb + vc;
    return {1.0 - (vb + vc) / sum, vb / sum, vc / sum};
}

/// Parameters (s, t) in [0, 1]² of the closest points a + s (b - a), c + t (d - c) of two segments (Ericson 2005,
/// section 5.1.9).
inline std::array<double, 2> closest_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a;
    const Vec3 v = d - c;
    const Vec3 w = a - c;
    const double uu = dot(u, u);
    const double vv = dot(v, v);
    const double uv = dot(u, v);
    const double uw = dot(u, w);
    const double vw = dot(v, w);
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 1e-14 * uu * vv ? std::clamp((uv * vw - uw * vv) / determinant, 0.0, 1.0) : 0.5;
    double t = vv > 0.0 ? (uv * s + vw) / vv : 0.0;
    if (t < 0.0)
    {
        t = 0.0;
        s = uu > 0.0 ? std::clamp(-uw / uu, 0.0, 1.0) : 0.0;
    }
    else if (t > 1.0)
    {
        t = 1.0;
        s = uu > 0.0 ? std::clamp((uv - uw) / uu, 0.0, 1.0) : 0.0;
    }
    return {s, t};
}

} // namespace corticle
