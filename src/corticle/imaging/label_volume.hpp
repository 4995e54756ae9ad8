// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace corticle
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
};

/// Lengths of the edges of a voxel [mm].
inline Vec3 voxel_edges(const VoxelFrame& frame)
{
    return {norm(frame.linear.column[0]), norm(frame.linear.column[1]), norm(frame.linear.column[2])};
}

} // namespace corticle
