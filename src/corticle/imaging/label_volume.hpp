// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace corticle::imaging
{

/// Voxel index -> scanner millimetres, RAS: x to the right, y anterior, z superior.
struct VoxelFrame
{
    Mat3 linear = Mat3::identity(); ///< its columns are the edges of a voxel [mm]
    Vec3 origin;                    ///< centre of voxel (0, 0, 0) [mm]

    Vec3 position(const Vec3& index) const { return origin + linear * index; }
};

/// An image of tissue labels.
struct LabelVolume
{
    std::array<std::int64_t, 3> size{}; ///< voxels along each axis
    VoxelFrame frame;
    std::vector<std::int32_t> labels; ///< x varies fastest
    std::vector<std::string> notes;   ///< what of the file's header was not taken as it stands, one line each
};

/// Is this number a whole one but for what arithmetic in single precision leaves: a unit in the last place or two of
/// `magnitude`, the largest number that it was computed from?
inline bool is_whole_label(double value, double magnitude)
{
    constexpr double least = 1e-3;
    constexpr double most = 0.25; // beyond about 500,000 single precision cannot distinguish whole numbers from others
    const double round_off = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * std::abs(magnitude);
    return std::abs(value - std::nearbyint(value)) <= std::clamp(round_off, least, most);
}

/// Lengths of the edges of a voxel [mm].
inline Vec3 voxel_edges(const VoxelFrame& frame)
{
    return {norm(frame.linear.column[0]), norm(frame.linear.column[1]), norm(frame.linear.column[2])};
}

} // namespace corticle::imaging
