// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace corticle::view
{

/// Red, green, blue, each from 0 to 1.
using Color = std::array<double, 3>;

/// The colour of `fraction` (clamped to 0 to 1; NaN gives grey) on a map: "viridis", "coolwarm" (diverging) or
/// "tissue" (white matter, a pale blue-grey, to cortex, a warm red). Another name gives viridis.
Color map_color(const std::string& map, double fraction);

} // namespace corticle::view
