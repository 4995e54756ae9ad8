// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/polar.hpp"
#include "corticle/material/options.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle::material
{

/// How far growth has come at t: f of g = 1 + alpha theta m f(t) [-].
struct GrowthCourse
{
    GrowthLaw law = GrowthLaw::linear;
    double onset = 0.0; ///< t at which growth starts (linear) or the steepest tangent leaves 0 (gompertz)
    double rate = 1.0;  ///< slope of f, its largest slope with "gompertz" [-]

    /// f(t): rate (t - onset), not below 0; or exp(-exp(e rate (onset - t) + 1)), from 0 to 1 (Zwietering et al. 1990).
    double value(double t) const
    {
        return law == GrowthLaw::linear ? std::max(0.0, rate * (t - onset)) : std::exp(-steepness(t));
    }
    /// df/dt
    double slope(double t) const
    {
        if (law == GrowthLaw::linear)
        {
            return t >= onset ? rate : 0.0;
        }
        return std::numbers::e * rate * steepness(t) * std::exp(-steepness(t));
    }

  private:
    double steepness(double t) const { return std::exp(std::numbers::e * rate * (onset - t) + 1.0); }
};

/// Inverse of the growth tensor G = g_t (I - n n^T) + g_r n n^T: tissue grows by g_t in the plane whose normal in the
/// reference frame is n and by g_r along n; g_r = g_t is isotropic. det G = g_t² g_r. (Tallinen et al. 2016 with
/// g_r = 1; thesis eq. 22 prints F G where F G^-1 is meant.)
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> inverse_growth_tensor(const Real& g_t, const BasicVec3<Real>& normal,
                                                      const Real& g_r = broadcast<Real>(1.0))
{
    constexpr ScalarOf<Real> one(1.0);
    return (one / g_t) * BasicMat3<Real>::identity() + (one / g_r - one / g_t) * outer(normal, normal);
}

/// Normal of the deformed material surface y = const, turned back by the rotation R of F = R U: R^T F^-T n / |F^-T n|,
/// which is U^-1 n / |U^-1 n|. With it G follows the deformed surface and stays in the reference frame: the same motion
/// seen after a rotation grows the same. n itself where U has it for a principal direction.
/// @param F  deformation gradient, det F > 0   @param normal  n, unit, reference
inline Vec3 current_normal(const Mat3& F, const Vec3& normal)
{
    return normalized(transpose(polar_rotation(F)) * (cofactor(F) * normal));
}

} // namespace corticle::material
