// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/tissue/discretization.hpp"
#include "corticle/tissue/tissue.hpp"
#include "corticle/tlsph/particles.hpp"

#include <algorithm>
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

/// Adds what a block of particles found to what the blocks before it did.
inline void join(InternalResponse& total, const InternalResponse& part)
{
    total.elastic_energy += part.elastic_energy;
    total.zero_mode_energy += part.zero_mode_energy;
    total.growth_power += part.growth_power;
    total.stiffest_rate = std::max(total.stiffest_rate, part.stiffest_rate);
    total.barrier_count += part.barrier_count;
    if (part.smallest_J < total.smallest_J)
    {
        total.smallest_J = part.smallest_J;
        total.smallest_J_at = part.smallest_J_at;
    }
    total.invalid_at = total.invalid_at < 0 ? part.invalid_at : total.invalid_at;
}

/// "particle 12: position ..., J = ..., 57 neighbours"
/// @param x  its position [mm]   @param F  its deformation gradient
std::string describe_particle(const Particles& particles, const Tissue& tissue, std::int64_t i, const Vec3& x,
                              const Mat3& F);

} // namespace corticle
