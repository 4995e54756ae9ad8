// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/surrogate/design.hpp"

#include <span>

namespace corticle::sensitivity
{

/// Paths through a grid of the unit cube of which each step changes one coordinate, every coordinate once (Morris
/// 1991): one path after the other, each of dimensions + 1 points. Steps are levels / (2 (levels - 1)).
/// @param levels  of the grid; even
std::vector<fit::Point> morris_paths(std::size_t count, std::size_t dimensions, std::size_t levels, std::uint64_t seed);

/// What one coordinate does to a value: statistics of its elementary effects, changes of the value over those of the
/// coordinate.
struct ElementaryEffects
{
    double mean = 0.0;
    double mean_magnitude = 0.0; ///< mu* of Campolongo et al. 2007: how much the coordinate matters
    double deviation = 0.0;      ///< standard deviation: curved, or dependent on other coordinates
    double error = 0.0;          ///< half of the 90 % interval of mean_magnitude
    std::size_t count = 0;       ///< effects: steps of which both ends have a value
};

/// @param points  of morris_paths   @param values  as many; NaN where there is none
std::vector<ElementaryEffects> elementary_effects(std::span<const fit::Point> points, std::span<const double> values);

} // namespace corticle::sensitivity
