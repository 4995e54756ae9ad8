// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace corticle::view
{

/// Red, green, blue, each from 0 to 1.
using Color = std::array<double, 3>;

enum class ColorMap
{
    viridis,
    cividis,
    coolwarm,    ///< diverging
    blue_orange, ///< diverging, dark at both ends
    grey,
    tissue ///< white matter, a pale blue-grey, to cortex, a warm red
};

/// The colour of `fraction` (clamped to 0 to 1; NaN gives grey) on a map.
Color map_color(ColorMap map, double fraction);

} // namespace corticle::view
