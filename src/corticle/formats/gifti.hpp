// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/field.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// GIFTI, the exchange format of neuroimaging surfaces (www.nitrc.org/projects/gifti, version 1.0).

namespace corticle::formats
{

using GiftiMetaData = std::map<std::string, std::string>;

/// A matrix, by rows, from the space of the coordinates to another; spaces are named as in NIfTI ("NIFTI_XFORM_...").
struct GiftiTransform
{
    std::string data_space;
    std::string transformed_space;
    std::array<double, 16> matrix{};
};

struct GiftiArray
{
    std::string intent; ///< "NIFTI_INTENT_POINTSET", ...
    GiftiMetaData metadata;
    std::vector<std::int64_t> dimensions;
    std::vector<double> values; ///< by rows, whatever the order in the file
    std::vector<GiftiTransform> transforms;

    std::int64_t rows() const { return dimensions.empty() ? 0 : dimensions[0]; }
    /// Numbers in each row.
    std::int64_t columns() const { return rows() == 0 ? 1 : static_cast<std::int64_t>(values.size()) / rows(); }
};

struct GiftiFile
{
    GiftiMetaData metadata;
    std::vector<GiftiArray> arrays;
};

/// Reads GIFTI from memory: text, base64 or compressed base64; either byte order; floats and integers of 8 to 64 bits;
/// numbers in files of their own (ExternalFileBinary) that lie in the folder of `name`.
/// @throws InputError, one line naming `name`, for what is no GIFTI, or damaged.
GiftiFile parse_gifti(std::string_view bytes, const std::string& name);

/// Writes a surface: float32 points in scanner RAS [mm] and int32 triangles, compressed. `structure` is what Connectome
/// Workbench calls the part of the brain ("CortexLeft", "CortexRight", "Cortex"); empty: not said.
/// @throws RunError when it cannot be written.
void write_surface_gifti(const std::filesystem::path& file, std::span<const Vec3> points,
                         std::span<const Triangle> triangles, const std::string& structure = {});

/// Writes scalars per vertex, one float32 array of intent SHAPE for each field. @throws RunError
void write_scalars_gifti(const std::filesystem::path& file, std::span<const Field> scalars,
                         const std::string& structure = {});

} // namespace corticle::formats
