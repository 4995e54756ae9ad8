// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <array>

namespace corticle
{

// Conditions on several numbers are one comparison, of the largest or the least of them: compilers take masks that are
// combined apart into single lanes. They combine them themselves where two choices in a row choose the same.

/// a limited to [0, 1]; 0 where it is NaN.
template <RealLike Real>
CORTICLE_INLINE Real limited_to_unit(const Real& a)
{
    return smaller(larger(a, Real{}), broadcast<Real>(1.0));
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
    // At most zero in the region of an edge or of a corner.
    const Real on_bc = larger(va, larger(d3 - d4, d6 - d5));
    const Real on_ac = larger(vb, larger(-d2, d6));
    const Real on_c = larger(-d6, d5 - d6);
    const Real on_ab = larger(vc, larger(-d1, d3));
    const Real on_b = larger(-d3, d4 - d3);
    const Real on_a = larger(d1, d2);
    const Real along_bc = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    Real at_b = vb / sum;
    at_b = on_bc <= 0.0 ? one - along_bc : at_b;
    at_b = smaller(on_ac, on_c) <= 0.0 ? zero : at_b;
    at_b = on_ab <= 0.0 ? d1 / (d1 - d3) : at_b;
    at_b = on_b <= 0.0 ? one : at_b;
    at_b = on_a <= 0.0 ? zero : at_b;
    Real at_c = vc / sum;
    at_c = on_bc <= 0.0 ? along_bc : at_c;
    at_c = on_ac <= 0.0 ? d2 / (d2 - d6) : at_c;
    at_c = on_c <= 0.0 ? one : at_c;
    at_c = smaller(on_ab, smaller(on_b, on_a)) <= 0.0 ? zero : at_c;
    return {one - (at_b + at_c), at_b, at_c};
}

/// Parameters (s, t) in [0, 1]² of the closest points a + s (b - a), c + t (d - c) of two segments (Ericson 2005,
/// section 5.1.9). Either may be a single point.
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
    const Real determinant = uu * vv - uv * uv;
    const Real inside =
        determinant > 1e-14 * uu * vv ? limited_to_unit((uv * vw - uw * vv) / determinant) : broadcast<Real>(0.5);
    const Real t = (uv * inside + vw) / vv; // NaN where c is d
    const Real at_c = limited_to_unit(-uw / uu);
    const Real at_d = limited_to_unit((uv - uw) / uu);
    return {t > 1.0 ? at_d : (t >= 0.0 ? inside : at_c), limited_to_unit(t)};
}

} // namespace corticle
