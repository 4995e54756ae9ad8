// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/report/page.hpp"

namespace corticle::report
{

// Arrays as a page holds them. Numbers become uint16 between the least and the largest value of their component: 0 to
// 65534, and 65535 for NaN. Differences of successive numbers (neighbours on the space-filling curve are alike) are
// taken apart into low and high bytes, which deflate well; then zlib, then base64. viewer/packing.mjs reads them.

/// An array as the content of a page describes it: {"blob", "count", "low": [...], "high": [...]}.
/// @param values  `components` numbers for each point
/// @param step    only every so many of the whole numbers are used: coarser, and smaller when deflated
Json pack_numbers(std::span<const double> values, std::size_t components, Blobs& blobs, int step = 1);

/// Whole numbers from 0 below 2^32: {"blob", "count"}; four planes of bytes.
Json pack_indices(std::span<const std::uint32_t> indices, Blobs& blobs);

/// Half a step of the numbers of an array between `low` and `high`: the largest error of packing.
constexpr double packing_error(double low, double high, int step = 1)
{
    return 0.5 * step * (high - low) / 65534.0;
}

} // namespace corticle::report
