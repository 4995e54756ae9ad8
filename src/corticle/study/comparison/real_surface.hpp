// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/formats/unit_of_length.hpp"
#include "corticle/imaging/options.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/metrics/surface_rows.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::study
{

/// How labels become a surface to be measured: smoothed as little as keeps the steps of voxels out of the area, and
/// not closed, so that open sulci count.
imaging::MaskOptions measuring_mask();

/// How a real brain is read.
struct RealSurfaceOptions
{
    formats::UnitOfLength unit = formats::UnitOfLength::mm; ///< of surface files
    formats::Coordinates coordinates = formats::Coordinates::scanner;
    imaging::MaskOptions mask = measuring_mask(); ///< of label volumes
};

/// A closed surface to be measured [mm], and what is to be known of it.
struct RealSurfaceReading
{
    TriangleMesh surface;
    double voxel_mm = 0.0;             ///< longest edge of the voxels of labels; 0: a surface file
    std::vector<std::string> notes;    ///< transformations and the like, one line each
    std::vector<std::string> warnings; ///< one line each
};

/// Reads a surface file as it is, or the surface of the labels of a NIfTI volume.
/// @throws InputError for a file that cannot be read, a surface that is damaged or open, labels that are not there, and
/// labels asked of a file that has none
RealSurfaceReading read_real_surface(const std::filesystem::path& file, const RealSurfaceOptions& options);

/// All measures of a real surface. The stairs of voxels are not folds: waves no higher than they do not count.
std::vector<metrics::SurfaceRow> surface_rows(const RealSurfaceReading& reading, metrics::FoldOptions options = {});

} // namespace corticle::study
