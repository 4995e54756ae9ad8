// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace corticle::cloud
{

/// Surface edges over the spacing: makes the cell of a surface particle about half of an inner one.
inline constexpr double edge_per_spacing = 1.05;

/// How the spacing grows with depth: fine in the cortex and a support below it, coarser in the core.
struct Grading
{
    double ratio = 1.0;     ///< spacing in the core over that at the surface, at least 1
    double cortex_mm = 0.0; ///< thickness of the cortex where it is largest, in the reference state

    bool is_uniform() const { return ratio <= 1.0; }

    /// Spacing at a depth below the surface [mm]. @param spacing  at the surface [mm]
    double spacing_at(double spacing, double depth) const
    {
        constexpr double slope = 0.25;        // of the spacing, below the fine part
        constexpr double fine_spacings = 2.5; // that are fine below the cortex
        const double below = std::max(depth - cortex_mm - fine_spacings * spacing, 0.0);
        return std::min(ratio * spacing, spacing + slope * below);
    }
};

struct CloudOptions
{
    double spacing = 0.0; ///< at the surface [mm]
    std::uint64_t seed = 1;
    Grading grading{};
};

} // namespace corticle::cloud
