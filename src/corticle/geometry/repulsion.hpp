// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::geometry
{

/// Moves that spread points [mm]: move_i = step * range_i * sum_j w(r_ij / range_ij) r_ij / |r_ij|, w(q) = (1 - q)²,
/// over the points closer than range_ij = (range_i + range_j) / 2, for the points from index `first` on; no longer than
/// `longest` ranges. The same bits for any number of threads.
/// @param ranges  one per point [mm]
void repulsion_moves(std::span<const Vec3> points, std::int64_t first, std::span<const double> ranges, double step,
                     double longest, std::vector<Vec3>& moves);

} // namespace corticle::geometry
