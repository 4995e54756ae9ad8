// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace corticle::material
{

/// Share of cortex at a material depth below the surface, a smooth step (thesis eq. 11):
/// theta = 1 / (1 + exp(10 (y/H - 1))), 1 in the cortex, 0 in the white matter.
/// @param depth      y, reference distance to the surface [mm]
/// @param thickness  H, cortical thickness [mm]
inline double smooth_layer(double depth, double thickness)
{
    return 1.0 / (1.0 + std::exp(10.0 * (depth / thickness - 1.0)));
}

/// The sharp step at particles: 1 in the outermost ones, as many as hold the volume of the cortex, 0 in the others; the
/// one at the boundary gets the rest. Deciding by centres alone would alias with the layers in which particles settle
/// below the surface: the volume of the cortex was off by up to 4 %.
/// @param inside         distance from the boundary to each particle, positive on the cortical side [mm]
/// @param volume         of each particle [mm³]
/// @param cortex_volume  [mm³]
std::vector<double> sharp_layer(std::span<const double> inside, std::span<const double> volume, double cortex_volume);

/// Volume of the parts of all cells that lie inside the boundary, each cell taken as a slab of width V^(1/3) across it
/// [mm³].
double volume_inside(std::span<const double> inside, std::span<const double> volume);

} // namespace corticle::material
