// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/pictures.hpp"
#include "corticle/view/plane_section.hpp"

namespace corticle::view
{

/// For each pixel of the mask the particle that the material there is nearest to; -1 outside the mask, and everywhere
/// when there are no particles.
///
/// A particle at x, which came from X with deformation gradient F, takes the material at p to have come from
/// X + F^-1 (p - x). What is at a pixel came from the weighted mean of that over the particles around it, which weigh
/// the less the farther |F^-1 (p - x)| they are away in the material, up to two spacings. The pixel shows the particle
/// that came from nearest to there. So stretched tissue, whose particles are far apart along the stretch, shows as one
/// piece, and a particle ahead of or behind its neighbours does not show as a speckle. Where there is no such mean, the
/// pixel shows the particle nearest in the material, or else nearest in space.
std::vector<std::int32_t> material_particles(const CutInput& input, const PixelGrid& grid,
                                             std::span<const std::uint8_t> mask);

} // namespace corticle::view
