// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace corticle
{

/// Share of cortex at a material depth below the surface, a smooth step (thesis eq. 11):
/// theta = 1 / (1 + exp(10 (y/H - 1))), 1 in the cortex, 0 in the white matter.
/// @param depth      y, reference distance to the surface [mm]
/// @param thickness  H, cortical thickness [mm]
inline double smooth_layer(double depth, double thickness)
{
    return 1.0 / (1.0 + std::exp(10.0 * (depth / thickness - 1.0)));
}

/// The sharp step: 1 where depth <= thickness, else 0.
inline double binary_layer(double depth, double thickness)
{
    return depth <= thickness ? 1.0 : 0.0;
}

} // namespace corticle
