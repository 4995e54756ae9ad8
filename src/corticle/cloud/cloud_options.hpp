// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace corticle::cloud
{

/// Surface edges over the spacing: makes the cell of a surface particle about half of an inner one.
inline constexpr double edge_per_spacing = 1.05;

struct CloudOptions
{
    double spacing = 0.0; ///< [mm]
    std::uint64_t seed = 1;
};

} // namespace corticle::cloud
