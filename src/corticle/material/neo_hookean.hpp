// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/volumetric.hpp"

namespace corticle::material
{

/// Compressible neo-Hookean solid (thesis eq. 18):
/// W = mu/2 (tr(F_e F_e^T) J_e^-2/3 - 3) + K/2 (J_e - 1)², with the barrier of volumetric_response.
struct NeoHookean
{
    double barrier_J = 0.0; ///< [-]

    /// @param F_e  elastic deformation gradient, det F_e > 0   @param cofactor_e,J_e  its cofactor and determinant
    template <RealLike Real>
    CORTICLE_INLINE DeviatoricResponse<Real> respond_to_shape(const Real& shear_modulus, const BasicMat3<Real>& F_e,
                                                              const BasicMat3<Real>& cofactor_e, const Real& J_e) const
    {
        using Scalar = ScalarOf<Real>;
        const Real r = inverse_cube_root(J_e);
        const Real scale = shear_modulus * r * r;
        const Real trace_C = contract(F_e, F_e);
        return {Scalar(0.5) * (scale * trace_C - Scalar(3.0) * shear_modulus),
                scale * F_e - (scale * trace_C / (Scalar(3.0) * J_e)) * cofactor_e};
    }

    template <RealLike Real>
    CORTICLE_INLINE VolumetricResponse<Real> respond_to_volume(const Real& bulk_modulus, const Real& J_e) const
    {
        return volumetric_response(bulk_modulus, J_e, barrier_J);
    }
};
static_assert(Material<NeoHookean> && Material<NeoHookean, float>);

} // namespace corticle::material
