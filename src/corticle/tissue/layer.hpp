// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// The sharp step as a particle sees it: the share of its cell that lies inside the cortex, taking the cell as a slab
/// of width V^(1/3) across the boundary. (A 0 or 1 by the particle's centre would alias with the layers in which
/// particles settle below the surface: the volume of the cortex was off by up to 4 %.)
/// @param inside_boundary  distance from the boundary to the particle, positive on the cortical side [mm]
/// @param cell_width       cube root of the particle's volume [mm]
inline double binary_layer(double inside_boundary, double cell_width)
{
    return std::clamp(0.5 + inside_boundary / cell_width, 0.0, 1.0);
}

} // namespace corticle
