// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace corticle
{

/// How a label image becomes a closed surface.
struct MaskOptions
{
    std::vector<std::int64_t> labels;   ///< the tissue of the body; empty: every label but 0
    std::optional<std::int64_t> volume; ///< which volume of a 4D image, from 0
    double closing_mm = 1.8;            ///< radius of the closing, which closes gaps up to twice as wide; 0: none
    bool fill_cavities = true;          ///< fill background that is cut off from the outside
    double smoothing_mm = 1.2;          ///< standard deviation of the Gaussian; 0: none
    bool remove_handles = true;         ///< make the surface a topological sphere
    std::string hemisphere = "both";    ///< "both" | "left" | "right"
};

} // namespace corticle
