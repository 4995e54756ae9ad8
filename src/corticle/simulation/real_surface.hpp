// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/triangle_mesh.hpp"
#include "corticle/imaging/options.hpp"

#include <filesystem>
#include <string>

namespace corticle
{

/// How labels become a surface to be measured: smoothed as little as keeps the steps of voxels out of the area, and
/// not closed, so that open sulci count.
MaskOptions measuring_mask();

/// How a real brain is read.
struct RealSurfaceOptions
{
    std::string unit = "mm";             ///< of length, of surface files
    MaskOptions mask = measuring_mask(); ///< of label volumes
};

/// A closed surface to be measured [mm]: a surface file as it is, or the surface of the labels of a NIfTI volume.
/// @throws InputError for a file that cannot be read, a surface that is damaged or open, labels that are not there, and
/// labels asked of a file that has none
TriangleMesh read_real_surface(const std::filesystem::path& file, const RealSurfaceOptions& options);

} // namespace corticle
