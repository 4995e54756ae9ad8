// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_source.hpp"

#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/tets/tet_reader.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "corticle/geometry/repair.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/validate_tets.hpp"
#include "corticle/prepare/label_surface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace corticle::prepare
{

namespace
{

/// Smoothing that takes the stairs of voxels out of a surface and leaves folds: 0.7 mm for voxels of 0.8 mm.
constexpr double smoothing_in_voxels = 0.875;
/// Smoothing that leaves nothing much finer than particles can follow.
constexpr double smoothing_in_spacings = 0.25;

/// Distance between particles, about, in the body that these labels are [mm].
double rough_spacing(const GeometryOptions& options, const imaging::LabelVolume& image)
{
    if (options.spacing_mm)
    {
        return *options.spacing_mm;
    }
    const std::vector<std::int64_t>& labels = options.mask.labels;
    const auto voxels = std::ranges::count_if(
        image.labels, [&](std::int32_t label)
        { return labels.empty() ? label != 0 : std::ranges::find(labels, label) != labels.end(); });
    const double volume = static_cast<double>(voxels) * std::abs(determinant(image.frame.linear));
    return std::cbrt(volume / static_cast<double>(options.particles.value_or(default_particles)));
}

void take_labels(const GeometryOptions& options, int coarsening, BodySource& source)
{
    source.kind = "labels";
    const imaging::LabelVolume image = read_label_image(options.file, options.mask, options.coordinates, source.notes);
    imaging::ImagedSurface imaged = label_surface(image, settled_mask(options, image, coarsening), options.file);
    source.surface = std::move(imaged.surface);
    std::ranges::copy(imaging::describe(imaged.report), std::back_inserter(source.notes));
    source.warnings = imaged.report.warnings;
    source.reports.mask = std::move(imaged.report);
}

void take_tets(const GeometryOptions& options, BodySource& source)
{
    source.kind = "tets";
    geometry::TetReport report;
    source.tets = geometry::require_valid_tets(
        formats::read_tets(options.file, formats::millimetres_per(options.unit), &source.notes), options.file, &report);
    std::ranges::copy(report.lines, std::back_inserter(source.notes));
    source.reports.tets = std::move(report);
    source.surface = boundary_of(*source.tets).surface;
}

void take_surface(const GeometryOptions& options, BodySource& source)
{
    source.kind = "surface";
    source.map_surface = formats::read_surface_unmerged(
        options.file, {formats::millimetres_per(options.unit), options.coordinates, &source.notes});
    geometry::RepairedSurface repaired =
        geometry::repair_surface(source.map_surface, options.file, options.repair, options.wrap);
    source.surface = std::move(repaired.mesh);
    std::ranges::copy(repaired.report.lines, std::back_inserter(source.notes));
    std::ranges::copy(repaired.report.warnings, std::back_inserter(source.warnings));
    source.reports.repair = std::move(repaired.report);
}

/// Area of an ellipsoid [mm²] within 1 % (Thomsen's formula, p = 1.6075); exact for a sphere.
double ellipsoid_area(const std::array<double, 3>& axes)
{
    constexpr double p = 1.6075;
    const double sum = std::pow(axes[0] * axes[1], p) + std::pow(axes[0] * axes[2], p) + std::pow(axes[1] * axes[2], p);
    return 4.0 * std::numbers::pi * std::pow(sum / 3.0, 1.0 / p);
}

} // namespace

imaging::MaskOptions settled_mask(const GeometryOptions& options, const imaging::LabelVolume& image, int coarsening)
{
    const Vec3 edges = imaging::voxel_edges(image.frame);
    const double spacing = rough_spacing(options, image);
    const double voxel = std::cbrt(edges.x * edges.y * edges.z);
    imaging::MaskOptions mask = options.mask;
    mask.closing_mm = options.closing_mm.value_or(std::min(10.0, 0.5 * coarsening * spacing));
    mask.smoothing_mm = options.smoothing_mm.value_or(
        std::min(5.0, std::max(smoothing_in_voxels * voxel, (1.0 + coarsening) * smoothing_in_spacings * spacing)));
    return mask;
}

std::array<double, 3> semi_axes(const GeometryOptions& options)
{
    return options.shape == Shape::sphere ? std::array{options.radius_mm, options.radius_mm, options.radius_mm}
                                          : options.semi_axes_mm;
}

TriangleMesh shape_surface(const GeometryOptions& options, double edge_length)
{
    const auto& [x, y, z] = options.size_mm;
    return options.shape == Shape::box ? geometry::make_box({x, y, z}, edge_length)
                                       : geometry::make_ellipsoid(semi_axes(options), edge_length);
}

bool can_coarsen(const GeometryOptions& options)
{
    return options.shape == Shape::file && formats::is_volume(options.file) &&
           !(options.closing_mm && options.smoothing_mm);
}

BodySource read_body_source(const GeometryOptions& options, int coarsening)
{
    BodySource source;
    if (options.shape != Shape::file)
    {
        if (options.shape == Shape::box)
        {
            const auto [x, y, z] = options.size_mm;
            source.kind = name_of(options.shape);
            source.volume = x * y * z;
            source.area = 2.0 * (x * y + y * z + x * z);
            return source;
        }
        const auto axes = semi_axes(options);
        source.kind = name_of(options.shape);
        source.volume = 4.0 / 3.0 * std::numbers::pi * axes[0] * axes[1] * axes[2];
        source.area = ellipsoid_area(axes);
        return source;
    }
    if (formats::is_volume(options.file))
    {
        take_labels(options, coarsening, source);
    }
    else if (formats::is_tet_file(options.file))
    {
        take_tets(options, source);
    }
    else
    {
        take_surface(options, source);
    }
    source.volume = enclosed_volume(source.surface.vertices, source.surface.triangles);
    source.area = surface_area(source.surface.vertices, source.surface.triangles);
    return source;
}

} // namespace corticle::prepare
