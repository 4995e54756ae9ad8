// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <string>

namespace corticle
{

/// An upper bound of 1 / (smallest singular value of F): sqrt of the bound m + sqrt(2) s of the largest eigenvalue
/// of F^-T F^-1 by its mean m and deviation s (Wolkowicz & Styan 1980); exact for isotropic and for uniaxial
/// compression.
template <RealLike Real>
CORTICLE_INLINE Real largest_compression(const BasicMat3<Real>& cofactor_F, const Real& J)
{
    const BasicMat3<Real> B = transpose(cofactor_F) * cofactor_F;
    const Real mean = trace(B) / 3.0;
    const Real variance = larger<Real>(contract(B, B) / 3.0 - mean * mean, Real{});
    return square_root(mean + square_root(2.0 * variance)) / J;
}

/// "particle 12: position ..., J = ..., 57 neighbours"
/// @param x  its position [mm]   @param F  its deformation gradient
std::string describe_particle(const Particles& particles, const Tissue& tissue, std::int64_t i, const Vec3& x,
                              const Mat3& F);

} // namespace corticle
