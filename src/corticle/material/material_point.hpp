// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"
#include "corticle/material/options.hpp"

namespace corticle::material
{

/// Moduli and growth of one material point at a time t.
template <RealLike Real>
struct BasicMaterialPoint
{
    Real growth;             ///< g_t, in the plane of the layer [-]
    Real radial_growth;      ///< g_r, along the normal [-]
    Real growth_rate;        ///< dg_t/dt [-]
    Real radial_growth_rate; ///< dg_r/dt [-]
    Real shear_modulus;      ///< mu [mu_w]
    Real bulk_modulus;       ///< K [mu_w]
    Real shear_rate{};       ///< dmu/dt where the layer moves [mu_w]
    Real bulk_rate{};        ///< dK/dt where the layer moves [mu_w]
};
using MaterialPoint = BasicMaterialPoint<double>;

/// mu = theta mu_c + (1 - theta) mu_w; K = ratio mu (per tissue) or one constant (uniform);
/// g_t = 1 + (alpha_t theta + alpha_white (1 - theta)) m f, g_r the same with alpha_r.
/// @param course  f, equal to t for the linear law; rates are per f, theta fixed
template <RealLike Real>
CORTICLE_INLINE BasicMaterialPoint<Real> material_point(const TissueOptions& options, const Real& theta,
                                                        const Real& regional_rate, double course)
{
    using Scalar = ScalarOf<Real>;
    const Scalar one(1.0);
    const auto f = static_cast<Scalar>(course);
    const auto bulk = static_cast<Scalar>(options.bulk_modulus);
    const Real share = one - theta;
    const Real mu = theta * static_cast<Scalar>(options.mu_cortex) + share * static_cast<Scalar>(options.mu_white);
    const Real white = static_cast<Scalar>(options.alpha_white) * share;
    const Real tangential = (static_cast<Scalar>(options.alpha_t) * theta + white) * regional_rate;
    const Real radial = (static_cast<Scalar>(options.alpha_r) * theta + white) * regional_rate;
    const Real K = options.bulk == BulkRule::per_tissue ? Real{bulk * mu} : broadcast<Real>(options.bulk_modulus);
    return {one + tangential * f, one + radial * f, tangential, radial, mu, K};
}

/// K + 4/3 mu, the stiffness against compression with the sides held: at density 1 the square of the speed of pressure
/// waves [mu_w].
template <RealLike Real>
CORTICLE_INLINE Real longitudinal_modulus(const BasicMaterialPoint<Real>& point)
{
    return point.bulk_modulus + ScalarOf<Real>(4.0 / 3.0) * point.shear_modulus;
}

} // namespace corticle::material
