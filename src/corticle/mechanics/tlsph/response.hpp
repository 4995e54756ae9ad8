// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <string>

namespace corticle::tlsph
{

/// "particle 12: position ..., J = ..., 57 neighbours"
/// @param x  its position [mm]   @param F  its deformation gradient
std::string describe_particle(const Particles& particles, const material::Tissue& tissue, std::int64_t i, const Vec3& x,
                              const Mat3& F);

} // namespace corticle::tlsph
