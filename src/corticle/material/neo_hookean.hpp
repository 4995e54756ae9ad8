// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <cmath>

namespace corticle
{

/// Energy density and first Piola-Kirchhoff stress of an elastic deformation.
template <RealLike Real>
struct BasicElasticResponse
{
    Real deviatoric_energy{}; ///< [mu_w]
    Real volumetric_energy{}; ///< barrier included [mu_w]
    BasicMat3<Real> stress;   ///< dW/dF_e [mu_w]
};
using ElasticResponse = BasicElasticResponse<double>;

/// Deviatoric part of the law.
template <RealLike Real>
struct DeviatoricResponse
{
    Real energy;            ///< [mu_w]
    BasicMat3<Real> stress; ///< dW/dF_e [mu_w]
};

/// Volumetric part of the law.
template <RealLike Real>
struct VolumetricResponse
{
    Real energy;   ///< barrier included [mu_w]
    Real pressure; ///< dW/dJ_e, positive in tension [mu_w]
};

/// Compressible neo-Hookean solid (thesis eq. 18):
/// W = mu/2 (tr(F_e F_e^T) J_e^-2/3 - 3) + K/2 (J_e - 1)².
/// W alone stays finite as J_e -> 0, so a crushed point does not push back; below J_e = barrier_J the term
/// K/2 ln²(J_e / barrier_J) is added, which is C1 at barrier_J and grows without bound. barrier_J = 0 leaves it out.
template <RealLike Real>
struct BasicNeoHookean
{
    Real shear_modulus; ///< mu [mu_w]
    Real bulk_modulus;  ///< K [mu_w]
    double barrier_J;   ///< [-]

    CORTICLE_INLINE VolumetricResponse<Real> respond_to_volume(Real J_e) const
    {
        Real pressure = bulk_modulus * (J_e - 1.0);
        Real energy = 0.5 * pressure * (J_e - 1.0);
        Real K = bulk_modulus;
        for_lanes(J_e < barrier_J,
                  [&](int lane)
                  {
                      if (barrier_J > 0.0) // averages over elements may be negative
                      {
                          const double depth = std::log(at_lane(J_e, lane) / barrier_J);
                          at_lane(energy, lane) += 0.5 * at_lane(K, lane) * depth * depth;
                          at_lane(pressure, lane) += at_lane(K, lane) * depth / at_lane(J_e, lane);
                      }
                  });
        return {energy, pressure};
    }

    /// @param F_e  elastic deformation gradient, det F_e > 0   @param cofactor_e,J_e  its cofactor and determinant
    CORTICLE_INLINE DeviatoricResponse<Real> respond_to_shape(const BasicMat3<Real>& F_e,
                                                              const BasicMat3<Real>& cofactor_e, const Real& J_e) const
    {
        const Real r = inverse_cube_root(J_e);
        const Real scale = shear_modulus * r * r;
        const Real trace_C = contract(F_e, F_e);
        return {0.5 * (scale * trace_C - 3.0 * shear_modulus),
                scale * F_e - (scale * trace_C / (3.0 * J_e)) * cofactor_e};
    }

    /// @param F_e  elastic deformation gradient, det F_e > 0
    CORTICLE_INLINE BasicElasticResponse<Real> respond(const BasicMat3<Real>& F_e) const
    {
        const BasicMat3<Real> cofactor_e = cofactor(F_e);
        const Real J_e = dot(F_e.column[0], cofactor_e.column[0]);
        const DeviatoricResponse<Real> shape = respond_to_shape(F_e, cofactor_e, J_e);
        const VolumetricResponse<Real> volume = respond_to_volume(J_e);
        return {shape.energy, volume.energy, shape.stress + volume.pressure * cofactor_e};
    }
};
using NeoHookean = BasicNeoHookean<double>;

/// Cauchy stress J_e^-1 P F_e^T [mu_w].
inline Mat3 cauchy_stress(const Mat3& elastic_stress, const Mat3& F_e)
{
    return (1.0 / determinant(F_e)) * (elastic_stress * transpose(F_e));
}

} // namespace corticle
