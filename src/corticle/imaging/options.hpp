// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace corticle::imaging
{

/// Which part of the mask is taken.
enum class Hemisphere
{
    both,
    left,
    right
};
constexpr std::array hemisphere_names{"both", "left", "right"};
constexpr const char* name_of(Hemisphere hemisphere)
{
    return hemisphere_names[static_cast<std::size_t>(hemisphere)];
}

/// How a label image becomes a closed surface.
struct MaskOptions
{
    std::vector<std::int64_t> labels;   ///< the tissue of the body; empty: every label but 0
    std::optional<std::int64_t> volume; ///< which volume of a 4D image, from 0
    std::optional<double> threshold;    ///< of a map of probabilities: the body is where it is at least this
    double closing_mm = 1.8;            ///< radius of the closing, which closes gaps up to twice as wide; 0: none
    bool fill_cavities = true;          ///< fill background that is cut off from the outside
    double smoothing_mm = 1.2;          ///< standard deviation of the Gaussian; 0: none
    bool remove_handles = true;         ///< make the surface a topological sphere
    Hemisphere hemisphere = Hemisphere::both;
};

} // namespace corticle::imaging
