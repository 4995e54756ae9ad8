// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace corticle::imaging
{

/// The box of voxels that a mask is worked on in. Its outermost layer is always background, so that the neighbours of
/// every other voxel are in it.
struct VoxelGrid
{
    std::array<std::int64_t, 3> size{};
    VoxelFrame frame; ///< from the index in this box

    std::int64_t count() const { return size[0] * size[1] * size[2]; }
    std::int64_t index(std::int64_t x, std::int64_t y, std::int64_t z) const { return (z * size[1] + y) * size[0] + x; }
    std::array<std::int64_t, 3> coordinates(std::int64_t index_) const
    {
        return {index_ % size[0], index_ / size[0] % size[1], index_ / (size[0] * size[1])};
    }
    /// Distance in the index between neighbours along an axis.
    std::int64_t stride(int axis) const { return axis == 0 ? 1 : (axis == 1 ? size[0] : size[0] * size[1]); }
    /// Is the voxel of the outermost layer?
    bool is_outermost(std::int64_t index_) const
    {
        const auto c = coordinates(index_);
        bool outermost = false;
        for (int axis = 0; axis < 3; ++axis)
        {
            outermost = outermost || c[axis] == 0 || c[axis] == size[axis] - 1;
        }
        return outermost;
    }
    Vec3 position(std::int64_t index_) const
    {
        const auto c = coordinates(index_);
        return frame.position({static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])});
    }
    double voxel_volume() const { return std::abs(determinant(frame.linear)); } ///< [mm³]
};

/// 1 inside, 0 outside, for each voxel of a grid.
using Mask = std::vector<std::uint8_t>;

/// @throws InputError, "mask: got 7 values, expected 1000", unless the grid has voxels and `count` is their number.
void require_voxels(const VoxelGrid& grid, std::string_view what, std::size_t count);

/// Number of voxels inside.
std::int64_t voxel_count(const Mask& mask);

} // namespace corticle::imaging
