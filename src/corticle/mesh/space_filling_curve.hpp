// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Place on the three-dimensional Hilbert curve of 2^16 steps a side (Skilling 2004), coordinates below 2^16.
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// Indices of the points in the order of a Hilbert curve over their bounding cube; equal places in ascending order.
std::vector<std::int32_t> hilbert_order(std::span<const Vec3> points);

} // namespace corticle
