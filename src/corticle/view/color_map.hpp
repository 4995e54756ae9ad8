// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

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
    tissue,           ///< white matter, a pale blue-grey, to cortex, a warm red
    viridis_reversed, ///< bright where values are small
    regions           ///< a colour for each whole number
};

inline constexpr std::array color_map_names{"viridis", "cividis", "coolwarm",         "blue-orange",
                                            "grey",    "tissue",  "viridis-reversed", "regions"};
/// "viridis"
const char* name_of(ColorMap map);

/// The colour of `fraction` (clamped to 0 to 1; NaN gives grey) on a map.
Color map_color(ColorMap map, double fraction);

/// The colour of a label on the map of regions; there are eight, in turn.
Color region_color(std::int64_t label);

} // namespace corticle::view
