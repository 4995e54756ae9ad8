// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/response.hpp"
#include "corticle/mechanics/tlsph/pair_law.hpp"

// What one particle makes of the sums over its neighbours: deformation, stress, energies, zero-energy control and its
// part of the forces. Neither threads nor arrays are known here. Symbols as in docs/theory/tlsph.md.

namespace corticle::tlsph
{

/// An upper bound of 1 / (smallest singular value of F): sqrt of the bound m + sqrt(2) s of the largest eigenvalue
/// of F^-T F^-1 by its mean m and deviation s (Wolkowicz & Styan 1980); exact for isotropic and for uniaxial
/// compression.
template <RealLike Real>
CORTICLE_INLINE Real largest_compression(const BasicMat3<Real>& cofactor_F, const Real& J)
{
    using Scalar = ScalarOf<Real>;
    const BasicMat3<Real> B = transpose(cofactor_F) * cofactor_F;
    const Real mean = trace(B) / Scalar(3.0);
    const Real variance = larger<Real>(contract(B, B) / Scalar(3.0) - mean * mean, Real{});
    return square_root<Real>(mean + square_root<Real>(Scalar(2.0) * variance)) / J;
}

/// zeta_i of the zero-energy control [mu_w]: it stiffens with growth as the tissue does.
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real control_stiffness(double zeta, const material::BasicMaterialPoint<Real>& point)
{
    const Real ratio = material::stiffening_ratio<plain>(point);
    return static_cast<ScalarOf<Real>>(zeta) * point.shear_modulus * ratio * ratio *
           material::normal_growth<plain>(point);
}

/// dzeta_i/dt / zeta_i, per unit of growth time.
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real control_stiffening(const material::BasicMaterialPoint<Real>& point)
{
    constexpr ScalarOf<Real> two(2.0);
    const Real tangential = point.growth_rate / point.growth;
    if constexpr (plain)
    {
        return two * tangential;
    }
    else
    {
        const Real radial = point.radial_growth_rate / point.radial_growth;
        const Real flattening = two * (tangential - radial);
        return point.shear_rate / point.shear_modulus + radial +
               (point.radial_growth <= point.growth ? flattening : Real{});
    }
}

/// F_i, its cofactor and its determinant.
template <RealLike Real>
struct ParticleDeformation
{
    BasicMat3<Real> F;
    BasicMat3<Real> cofactor_F;
    Real J;
};

template <RealLike Real>
CORTICLE_INLINE ParticleDeformation<Real> particle_deformation(const BasicMat3<Real>& F)
{
    ParticleDeformation<Real> result;
    result.F = F;
    result.cofactor_F = cofactor(result.F);
    result.J = dot(result.F.column[0], result.cofactor_F.column[0]);
    return result;
}

/// What a particle adds to the body, and what its neighbours read of it.
template <RealLike Real>
struct ParticleResponse
{
    Real elastic_energy;    ///< [mu_w mm³]
    Real zero_mode_energy;  ///< [mu_w mm³]
    Real growth_power;      ///< that of the zero-energy control included [mu_w mm³]
    Real rate;              ///< wave speed at density 1 over the smallest principal stretch
    Real J_e;               ///< elastic volume ratio
    Real zeta;              ///< zeta_i [mu_w]
    BasicMat3<Real> stress; ///< V_i P_i [mu_w mm³]
};

/// @param normal  n, that growth is tangential to   @param volume  V_i [mm³]   @param zeta  of TlsphOptions
/// @param residual  of the fit [mm³]
template <bool plain, RealLike Real, material::Material<Real> Law>
CORTICLE_INLINE ParticleResponse<Real>
particle_response(const Law& law, const material::BasicMaterialPoint<Real>& point, const BasicVec3<Real>& normal,
                  const Real& volume, double zeta, const ParticleDeformation<Real>& deformation, const Real& residual)
{
    const material::BasicResponse<Real> grown = material::respond<plain>(law, point, normal, deformation.F);
    const Real grown_volume = volume * grown.growth_volume;
    const Real stiffness = control_stiffness<plain>(zeta, point);
    const Real zero_mode = ScalarOf<Real>(0.5) * stiffness * residual;
    return {grown_volume * grown.energy,
            zero_mode,
            grown_volume * grown.power + control_stiffening<plain>(point) * zero_mode,
            grown.wave_speed * largest_compression(deformation.cofactor_F, deformation.J),
            grown.J_e,
            stiffness,
            volume * grown.P};
}

} // namespace corticle::tlsph
