// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/growth.hpp"
#include "corticle/material/material.hpp"
#include "corticle/material/material_point.hpp"

// What a material point that grows and deforms answers: the one place where the growth tensor meets a law. Known to
// every method, to threads and memory it knows nothing. F = F_e G; energies are of the grown, stress-free volume, which
// is growth_volume = det G times that of the reference. See docs/theory/tlsph.md.
//
// `plain` promises the compiler that growth is that of Tissue::grows_plainly: g_r = 1, and the moduli do not change.

namespace corticle::material
{

/// g_r
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real normal_growth(const BasicMaterialPoint<Real>& point)
{
    return plain ? broadcast<Real>(1.0) : point.radial_growth;
}

/// det G
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real growth_volume(const BasicMaterialPoint<Real>& point)
{
    return point.growth * point.growth * normal_growth<plain>(point);
}

/// Growth stiffens the tangent, pulled back to the reference, by det G / (smallest growth)² = ratio² g_r: this ratio.
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real stiffening_ratio(const BasicMaterialPoint<Real>& point)
{
    if constexpr (plain)
    {
        return point.growth;
    }
    else
    {
        return point.radial_growth <= point.growth ? Real{point.growth / point.radial_growth} : broadcast<Real>(1.0);
    }
}

/// K + 4/3 mu, and what the law adds to it.
template <RealLike Real, Material<Real> Law>
CORTICLE_INLINE Real longitudinal_modulus(const Law& law, const BasicMaterialPoint<Real>& point)
{
    if constexpr (requires { law.added_stiffness(point.shear_modulus); })
    {
        return longitudinal_modulus(point) + law.added_stiffness(point.shear_modulus);
    }
    else
    {
        return longitudinal_modulus(point);
    }
}

/// Speed of pressure waves at density 1 in the grown tissue, in the reference: sqrt((K + 4/3 mu) ratio² g_r).
template <bool plain = false, RealLike Real, Material<Real> Law>
CORTICLE_INLINE Real grown_wave_speed(const Law& law, const BasicMaterialPoint<Real>& point)
{
    return stiffening_ratio<plain>(point) *
           square_root<Real>(normal_growth<plain>(point) * longitudinal_modulus(law, point));
}

/// F_e = F G^-1.
template <RealLike Real>
struct ElasticDeformation
{
    BasicMat3<Real> inverse_G;
    BasicMat3<Real> F_e;
    BasicMat3<Real> cofactor_e;
    Real J_e;
};

/// @param normal  n, unit, that growth is tangential to, in the reference   @param F  deformation gradient
template <bool plain = false, RealLike Real>
CORTICLE_INLINE ElasticDeformation<Real> elastic_deformation(const BasicMaterialPoint<Real>& point,
                                                             const BasicVec3<Real>& normal, const BasicMat3<Real>& F)
{
    ElasticDeformation<Real> e;
    e.inverse_G = inverse_growth_tensor(point.growth, normal, normal_growth<plain>(point));
    e.F_e = F * e.inverse_G;
    e.cofactor_e = cofactor(e.F_e);
    e.J_e = dot(e.F_e.column[0], e.cofactor_e.column[0]);
    return e;
}

/// 2 g_t'/g_t + g_r'/g_r: rate at which the grown volume increases, over that volume.
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real swelling_rate(const BasicMaterialPoint<Real>& point)
{
    const Real tangential = ScalarOf<Real>(2.0) * (point.growth_rate / point.growth);
    return plain ? tangential : Real{tangential + point.radial_growth_rate / point.radial_growth};
}

/// Rate of the energy at fixed F and n, per unit of growth time and of grown volume: new volume brings energy along,
/// growth does work against the stress, and moduli change where the layer moves [mu_w].
/// @param F_e  elastic deformation gradient   @param elastic  energies and stress there
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real growth_power(const BasicMaterialPoint<Real>& point, const BasicVec3<Real>& normal,
                                  const BasicMat3<Real>& F_e, const BasicElasticResponse<Real>& elastic)
{
    const Real radial_work = dot(elastic.stress * normal, F_e * normal);
    const Real tangential_work = contract(elastic.stress, F_e) - radial_work;
    const Real energy = elastic.deviatoric_energy + elastic.volumetric_energy;
    const Real power = swelling_rate<plain>(point) * energy - point.growth_rate / point.growth * tangential_work;
    if constexpr (plain)
    {
        return power;
    }
    else
    {
        return power - point.radial_growth_rate / point.radial_growth * radial_work +
               elastic.deviatoric_energy * point.shear_rate / point.shear_modulus +
               elastic.volumetric_energy * point.bulk_rate / point.bulk_modulus;
    }
}

/// What a grown material point answers to a deformation.
template <RealLike Real>
struct BasicResponse
{
    Real growth_volume; ///< det G
    Real energy;        ///< W(F_e), per grown volume [mu_w]
    Real power;         ///< growth_power, per grown volume [mu_w]
    Real wave_speed;    ///< grown_wave_speed
    Real J_e;           ///< elastic volume ratio, which the barrier looks at
    BasicMat3<Real> P;  ///< first Piola-Kirchhoff stress: derivative of growth_volume · energy by F [mu_w]
};
using Response = BasicResponse<double>;

/// The law of a material point of whatever formulation. @param normal  n, unit, that growth is tangential to, in the
/// reference frame   @param F  deformation gradient, det F > 0
template <bool plain = false, RealLike Real, Material<Real> Law>
CORTICLE_INLINE BasicResponse<Real> respond(const Law& law, const BasicMaterialPoint<Real>& point,
                                            const BasicVec3<Real>& normal, const BasicMat3<Real>& F)
{
    const ElasticDeformation<Real> e = elastic_deformation<plain>(point, normal, F);
    const BasicElasticResponse<Real> elastic =
        elastic_response(law, point.shear_modulus, point.bulk_modulus, e.F_e, e.cofactor_e, e.J_e);
    const Real J_g = growth_volume<plain>(point);
    return {J_g,
            elastic.deviatoric_energy + elastic.volumetric_energy,
            growth_power<plain>(point, normal, e.F_e, elastic),
            grown_wave_speed<plain>(law, point),
            e.J_e,
            J_g * (elastic.stress * e.inverse_G)};
}

} // namespace corticle::material
