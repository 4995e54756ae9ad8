// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mesh/cloud.hpp"
#include "corticle/prepare/options.hpp"

#include <span>

namespace corticle::prepare
{

/// Directions of the fibres at some places and the share of white matter there, as the options ask for them; `tissue`
/// is complete otherwise. @param body  whose centroid a radial fan starts from
/// @throws InputError where a file of vectors cannot be read or none of them is near a place
void set_fibres(const PreparationOptions& options, const Cloud& body, std::span<const Vec3> places,
                material::TissueFields& tissue);

} // namespace corticle::prepare
