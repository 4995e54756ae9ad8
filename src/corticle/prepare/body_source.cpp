// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_source.hpp"

#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/tets/tet_reader.hpp"
#include "corticle/formats/volumes/nifti.hpp"
#include "corticle/geometry/repair.hpp"
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

void take_labels(const GeometryOptions& options, BodySource& source)
{
    source.kind = "labels";
    imaging::ImagedSurface imaged = read_label_surface(options.file, options.mask, options.coordinates, source.notes);
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

std::array<double, 3> semi_axes(const GeometryOptions& options)
{
    return options.shape == Shape::sphere ? std::array{options.radius_mm, options.radius_mm, options.radius_mm}
                                          : options.semi_axes_mm;
}

BodySource read_body_source(const GeometryOptions& options)
{
    BodySource source;
    if (options.shape != Shape::file)
    {
        const auto axes = semi_axes(options);
        source.kind = name_of(options.shape);
        source.volume = 4.0 / 3.0 * std::numbers::pi * axes[0] * axes[1] * axes[2];
        source.area = ellipsoid_area(axes);
        return source;
    }
    if (formats::is_nifti(options.file))
    {
        take_labels(options, source);
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
