// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/volumetric.hpp"

namespace corticle::test
{

/// A material added from outside: compressible Mooney-Rivlin solid,
/// W = mu/2 ((1 - s) (I_1 J^-2/3 - 3) + s (I_2 J^-4/3 - 3)) and the volumetric part of the neo-Hookean one, with
/// I_1 = tr C, I_2 = |cof F_e|² (Mooney 1940, Rivlin 1948; volume taken out as by Ogden 1978).
struct MooneyRivlin
{
    double second_share = 0.0; ///< s, share of the second invariant in the shear modulus [-]
    double barrier_J = 0.0;    ///< [-]

    template <RealLike Real>
    CORTICLE_INLINE material::DeviatoricResponse<Real>
    respond_to_shape(const Real& shear_modulus, const BasicMat3<Real>& F_e, const BasicMat3<Real>& cofactor_e,
                     const Real& J_e) const
    {
        using Scalar = ScalarOf<Real>;
        const Real r = inverse_cube_root(J_e);
        const Real first = Scalar(0.5 * (1.0 - second_share)) * shear_modulus * r * r;
        const Real second = Scalar(0.5 * second_share) * shear_modulus * r * r * r * r;
        const Real I_1 = contract(F_e, F_e);
        const Real I_2 = contract(cofactor_e, cofactor_e);
        const BasicMat3<Real> half_slope = (first + second * I_1) * F_e - second * (F_e * (transpose(F_e) * F_e));
        const Real volume_slope = (Scalar(2.0) * first * I_1 + Scalar(4.0) * second * I_2) / (Scalar(3.0) * J_e);
        return {first * I_1 + second * I_2 - Scalar(1.5) * shear_modulus,
                Scalar(2.0) * half_slope - volume_slope * cofactor_e};
    }

    template <RealLike Real>
    CORTICLE_INLINE material::VolumetricResponse<Real> respond_to_volume(const Real& bulk_modulus,
                                                                         const Real& J_e) const
    {
        return material::volumetric_response(bulk_modulus, J_e, barrier_J);
    }
};
static_assert(material::Material<MooneyRivlin> && material::Material<MooneyRivlin, float>);

} // namespace corticle::test
