// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/real_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/orientation.hpp"
#include "corticle/prepare/label_surface.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::study
{

namespace
{

/// Stairs of voxels, smoothed for measuring, are waves of at most 0.06 voxels (root mean square) at any wavelength:
/// ellipsoids of 9 to 60 voxels, upright and tilted. Waves that are not well above that are not folds.
constexpr double least_wave_height_in_voxels = 0.15;

} // namespace

imaging::MaskOptions measuring_mask()
{
    imaging::MaskOptions mask;
    mask.closing_mm = 0.0;
    mask.smoothing_mm = 0.7;
    return mask;
}

RealSurfaceReading read_real_surface(const std::filesystem::path& file, const RealSurfaceOptions& options)
{
    RealSurfaceReading reading;
    if (formats::is_volume(file))
    {
        imaging::ImagedSurface imaged =
            prepare::read_label_surface(file, options.mask, options.coordinates, reading.notes);
        reading.surface = std::move(imaged.surface);
        reading.warnings = std::move(imaged.report.warnings);
        reading.notes.push_back(imaging::describe_place(reading.surface.vertices));
        const Vec3& edges = imaged.report.voxel_mm;
        reading.voxel_mm = std::max({edges.x, edges.y, edges.z});
        return reading;
    }
    if (!options.mask.labels.empty())
    {
        throw InputError(
            fmt::format("{}: --labels is given, but this is no label volume; expected a NIfTI or MGH file, or no "
                        "--labels",
                        file.string()));
    }
    reading.surface =
        formats::read_surface(file, {formats::millimetres_per(options.unit), options.coordinates, &reading.notes});
    geometry::require_valid_surface(reading.surface, file.string());
    reading.notes.push_back(imaging::describe_place(reading.surface.vertices));
    return reading;
}

std::vector<metrics::SurfaceRow> surface_rows(const RealSurfaceReading& reading, metrics::FoldOptions options)
{
    options.least_wave_height_mm = least_wave_height_in_voxels * reading.voxel_mm;
    return metrics::surface_rows(reading.surface.vertices, reading.surface.triangles, options);
}

} // namespace corticle::study
