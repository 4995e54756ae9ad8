// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/options.hpp"

namespace corticle::material
{

/// When and how finely a flat cortex on deep white matter begins to fold.
struct CriticalLayer
{
    double growth;     ///< tangential growth of the cortex over that of the white matter [-]; infinity: never
    double wavelength; ///< in thicknesses of the cortex [-]
};

/// First instability of a sharp, flat layer that grows on a half-space of white matter: small waves on the compressed
/// layer (incremental elasticity), each wavelength with the growth at which it needs no force.
/// Depends on the moduli alone: growth along the normal changes the thickness and no stress.
CriticalLayer critical_layer(const TissueOptions& options);

} // namespace corticle::material
