// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <concepts>
#include <type_traits>

namespace corticle::material
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

/// Deviatoric part of a law.
template <RealLike Real>
struct DeviatoricResponse
{
    Real energy;            ///< [mu_w]
    BasicMat3<Real> stress; ///< dW/dF_e [mu_w]
};

/// Volumetric part of a law.
template <RealLike Real>
struct VolumetricResponse
{
    Real energy;   ///< barrier included [mu_w]
    Real pressure; ///< dW/dJ_e, positive in tension [mu_w]
};

/// What a law of the tissue offers: W = mu w(F_e) + K U(J_e), with w the same for all multiples of F_e. It holds its
/// constants; the moduli mu and K are those of the material point. At rest mu is the shear modulus, K the bulk modulus:
/// the stable step follows from them. Below J_e = barrier_J it resists further compression; 0: it never does.
template <class Law, class Real = double>
concept Material = RealLike<Real> && std::is_trivially_copyable_v<Law> &&
    requires(const Law& law, const Real& modulus, const BasicMat3<Real>& F_e, const Real& J_e)
{
    {
        law.respond_to_shape(modulus, F_e, F_e, J_e)
        } -> std::same_as<DeviatoricResponse<Real>>;
    {
        law.respond_to_volume(modulus, J_e)
        } -> std::same_as<VolumetricResponse<Real>>;
    {
        law.barrier_J
        } -> std::convertible_to<double>;
};

/// The whole law. @param F_e  elastic deformation gradient   @param cofactor_e,J_e  its cofactor and determinant > 0
template <RealLike Real, Material<Real> Law>
CORTICLE_INLINE BasicElasticResponse<Real> elastic_response(const Law& law, const Real& shear_modulus,
                                                            const Real& bulk_modulus, const BasicMat3<Real>& F_e,
                                                            const BasicMat3<Real>& cofactor_e, const Real& J_e)
{
    const DeviatoricResponse<Real> shape = law.respond_to_shape(shear_modulus, F_e, cofactor_e, J_e);
    const VolumetricResponse<Real> volume = law.respond_to_volume(bulk_modulus, J_e);
    return {shape.energy, volume.energy, shape.stress + volume.pressure * cofactor_e};
}
template <RealLike Real, Material<Real> Law>
CORTICLE_INLINE BasicElasticResponse<Real> elastic_response(const Law& law, const Real& shear_modulus,
                                                            const Real& bulk_modulus, const BasicMat3<Real>& F_e)
{
    const BasicMat3<Real> cofactor_e = cofactor(F_e);
    return elastic_response(law, shear_modulus, bulk_modulus, F_e, cofactor_e,
                            dot(F_e.column[0], cofactor_e.column[0]));
}

/// Cauchy stress J_e^-1 P F_e^T [mu_w].
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> cauchy_stress(const BasicMat3<Real>& elastic_stress, const BasicMat3<Real>& F_e)
{
    return (ScalarOf<Real>(1.0) / determinant(F_e)) * (elastic_stress * transpose(F_e));
}

} // namespace corticle::material
