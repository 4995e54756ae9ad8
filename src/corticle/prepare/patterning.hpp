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

} // namespace corticle::prepare
