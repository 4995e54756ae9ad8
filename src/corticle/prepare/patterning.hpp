// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/prepare/options.hpp"

#include <span>

namespace corticle::prepare
{

/// Times of maps that have been read, in t.
void set_growth_times(const PreparationOptions& options, material::GrowthMaps& maps);

/// Multiplies m by 1 + amplitude · waves, not below 0: a smooth random field of one wavelength, taken at the closest
/// point of the surface. Without amplitude nothing.
void apply_protomap(const MapOptions& options, std::span<const Vec3> places, material::TissueFields& tissue);

/// Real spherical harmonics of degree 1 to 3, in order of degree l and, within, of order -l to l.
inline constexpr std::size_t growth_mode_count = 15;

/// One of them in a direction from the centre of the body, of mean square 1 over all directions: the first three are y,
/// z and x. With x to the right, y to the front and z up they are more growth in front, above, and on the right.
/// @param direction  of length 1
double growth_mode(std::size_t mode, const Vec3& direction);

/// Multiplies m by 1 + sum of amplitude · growth_mode, not below 0, in the direction from the centroid of the body to
/// the closest point of the surface. Without amplitudes nothing.
void apply_modes(std::span<const double> amplitudes, std::span<const Vec3> places, material::TissueFields& tissue);

} // namespace corticle::prepare
