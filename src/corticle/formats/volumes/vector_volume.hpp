// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <filesystem>

namespace corticle::formats
{

/// An image of vectors.
struct VectorVolume
{
    std::array<std::int64_t, 3> size{}; ///< voxels along each axis
    imaging::VoxelFrame frame;
    std::vector<Vec3> vectors; ///< x varies fastest; along the axes of the scanner

    /// The vector of the voxel at an index between those of voxels; null outside.
    const Vec3* at(const Vec3& index) const;
};

/// Reads three numbers a voxel from a NIfTI or MGH file, as read_labels does labels: 4D or 5D with three volumes, one
/// for each component. @throws InputError, one line naming the file, where it is missing, truncated, of another kind,
/// or holds numbers that are not finite
VectorVolume read_vectors(const std::filesystem::path& file);

} // namespace corticle::formats
