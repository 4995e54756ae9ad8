// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <array>

namespace corticle
{

/// a limited to [0, 1].
template <RealLike Real>
CORTICLE_INLINE Real limited_to_unit(const Real& a)
{
    return a < 0.0 ? broadcast<Real>(0.0) : (a > 1.0 ? broadcast<Real>(1.0) : a);
}

/// Barycentric weights of the point of triangle abc closest to p (Ericson 2005, section 5.1.5). The regions are tried
/// from the face to the corners, so that the first of the book's order wins; those not chosen may divide by zero.
template <RealLike Real>
CORTICLE_INLINE std::array<Real, 3> closest_on_triangle(const BasicVec3<Real>& p, const BasicVec3<Real>& a,
                                                        const BasicVec3<Real>& b, const BasicVec3<Real>& c)
{
    const BasicVec3<Real> ab = b - a;
    const BasicVec3<Real> ac = c - a;
    const Real d1 = dot(ab, p - a);
    const Real d2 = dot(ac, p - a);
    const Real d3 = dot(ab, p - b);
    const Real d4 = dot(ac, p - b);
    const Real d5 = dot(ab, p - c);
    const Real d6 = dot(ac, p - c);
    const Real va = d3 * d6 - d5 * d4;
    const Real vb = d5 * d2 - d1 * d6;
    const Real vc = d1 * d4 - d3 * d2;
    const Real sum = va + vb + vc;
    const Real zero{};
    const Real one = broadcast<Real>(1.0);
    Real at_b = vb / sum;
    Real at_c = vc / sum;
    const auto choose = [&](const auto& here, const Real& b_weight, const Real& c_weight)
    {
        at_b = here ? b_weight : at_b;
        at_c = here ? c_weight : at_c;
    };
    const Real along_bc = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    choose((va <= 0.0) & (d4 - d3 >= 0.0) & (d5 - d6 >= 0.0), one - along_bc, along_bc);
    choose((vb <= 0.0) & (d2 >= 0.0) & (d6 <= 0.0), zero, d2 / (d2 - d6));
    choose((d6 >= 0.0) & (d5 <= d6), zero, one);
    choose((vc <= 0.0) & (d1 >= 0.0) & (d3 <= 0.0), d1 / (d1 - d3), zero);
    choose((d3 >= 0.0) & (d4 <= d3), one, zero);
    choose((d1 <= 0.0) & (d2 <= 0.0), zero, zero);
    return {one - (at_b + at_c), at_b, at_c};
}

/// Parameters (s, t) in [0, 1]² of the closest points a + s (b - a), c + t (d - c) of two segments (Ericson 2005,
/// section 5.1.9).
template <RealLike Real>
CORTICLE_INLINE std::array<Real, 2> closest_of_segments(const BasicVec3<Real>& a, const BasicVec3<Real>& b,
                                                        const BasicVec3<Real>& c, const BasicVec3<Real>& d)
{
    const BasicVec3<Real> u = b - a;
    const BasicVec3<Real> v = d - c;
    const BasicVec3<Real> w = a - c;
    const Real uu = dot(u, u);
    const Real vv = dot(v, v);
    const Real uv = dot(u, v);
    const Real uw = dot(u, w);
    const Real vw = dot(v, w);
    const Real zero{};
    const Real determinant = uu * vv - uv * uv;
    const Real inside =
        determinant > 1e-14 * uu * vv ? limited_to_unit((uv * vw - uw * vv) / determinant) : broadcast<Real>(0.5);
    const Real t = vv > 0.0 ? (uv * inside + vw) / vv : zero;
    const Real at_c = uu > 0.0 ? limited_to_unit(-uw / uu) : zero;
    const Real at_d = uu > 0.0 ? limited_to_unit((uv - uw) / uu) : zero;
    return {t < 0.0 ? at_c : (t > 1.0 ? at_d : inside), limited_to_unit(t)};
}

} // namespace corticle
