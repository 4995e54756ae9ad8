// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/comparison.hpp"

#include <cstdint>
#include <map>
#include <span>

namespace corticle::metrics
{

/// Area of each region of a surface [mm²], the area of a triangle shared among its corners.
/// @param labels  of the region that each vertex is in, whole numbers
std::map<std::int64_t, double> region_areas(const SurfaceView& surface, std::span<const double> labels);

} // namespace corticle::metrics
