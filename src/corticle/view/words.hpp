// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/color_map.hpp"

#include <span>
#include <string>
#include <string_view>

namespace corticle::view
{

/// A key in words: "sulcal_depth_mean_mm" is "sulcal depth, mean".
std::string label_of(std::string_view key);

/// A unit as people write it: "mm2" is "mm²", "-" is nothing.
std::string unit_text(std::string_view unit);

/// A key in words with its unit: "sulcal depth, mean [mm]".
std::string titled(std::string_view key, std::string_view unit);

/// What an array of surface files is, and how it is coloured.
struct Scalar
{
    std::string_view key;
    std::string_view unit;
    std::string_view sentence;
    ColorMap map;
};

/// In the order in which they are offered.
std::span<const Scalar> known_scalars();

/// The entry of a key; of an array that is not known, one without unit and sentence, in viridis.
Scalar scalar_of(std::string_view key);

} // namespace corticle::view
