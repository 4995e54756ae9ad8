// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_measures.hpp"

#include "corticle/geometry/alpha_wrap.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/surface/local_gyrification.hpp"
#include "corticle/metrics/surface/spectrum.hpp"
#include "corticle/metrics/surface/sulcal_depth.hpp"
#include "corticle/metrics/surface/sulcal_pits.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace corticle::metrics
{

namespace
{

constexpr double adult_radius_mm = 67.0;
constexpr double least_ball_share = 0.05;          ///< of the root of the hull's area: matters for thin sheets only
constexpr double least_curvature_variation = 0.02; ///< of H over its mean square root: less is a smooth body

/// Size of the body over that of an adult brain.
double scale_of(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    const double volume = std::abs(enclosed_volume(vertices, triangles));
    return std::cbrt(3.0 * volume / (4.0 * std::numbers::pi)) / adult_radius_mm;
}

template <class Value>
double area_mean(std::span<const double> areas, Value&& value)
{
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
        sum += areas[v] * value(v);
        total += areas[v];
    }
    return sum / total;
}

TriangleMesh outer_surface(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           const FoldOptions& options)
{
    if (options.outer == OuterSurface::hull)
    {
        return geometry::convex_hull(vertices);
    }
    return geometry::closed_around({{vertices.begin(), vertices.end()}, {triangles.begin(), triangles.end()}},
                                   options.adult_closing_mm * scale_of(vertices, triangles));
}

double curvature_wavelength(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                            std::span<const double> mean_curvature, std::span<const double> areas,
                            double least_wave_height_mm)
{
    const double mean = area_mean(areas, [&](std::size_t v) { return mean_curvature[v]; });
    const double square = area_mean(areas, [&](std::size_t v) { return mean_curvature[v] * mean_curvature[v]; });
    if (square - mean * mean <= least_curvature_variation * least_curvature_variation * square)
    {
        return 0.0;
    }
    FoldBand band = fold_band(vertices, triangles);
    band.least_height = least_wave_height_mm;
    return dominant_wavelength(laplace_beltrami_spectrum(vertices, triangles, mean_curvature), band);
}

} // namespace

FoldFields fold_fields(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const FoldOptions& options)
{
    require_triangles(vertices, triangles);
    const TriangleMesh around = outer_surface(vertices, triangles, options);
    const geometry::SurfaceTree outer(around.vertices, around.triangles);
    const double least_ball = least_ball_share * std::sqrt(surface_area(around.vertices, around.triangles));
    const double ball = std::max(least_ball, options.adult_ball_mm * scale_of(vertices, triangles));
    return {vertex_curvature(vertices, triangles), sulcal_depth(vertices, triangles, outer),
            local_gyrification(vertices, triangles, outer, ball)};
}

FoldMeasures measure_folds(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           const FoldFields& fields, const FoldOptions& options)
{
    require_triangles(vertices, triangles);
    require_size("curvature of the vertices", fields.curvature.mean.size(), vertices.size());
    require_size("sulcal depth of the vertices", fields.sulcal_depth.size(), vertices.size());
    require_size("local gyrification of the vertices", fields.local_gyrification.size(), vertices.size());
    const std::vector<double> areas = vertex_areas(vertices, triangles);
    const auto mean = [&](std::span<const double> values)
    { return area_mean(areas, [values](std::size_t v) { return std::abs(values[v]); }); };
    const DepthExtrema extrema =
        depth_extrema(fields.sulcal_depth, triangles, options.adult_ridge_height_mm * scale_of(vertices, triangles));
    const Asymmetry sides = asymmetry(vertices, triangles, options.midplane.value_or(mid_sagittal_plane(vertices)));
    FoldMeasures m;
    m.gi_zilles = zilles_index(vertices, triangles, options.slices).index;
    m.gi_local_mean = mean(fields.local_gyrification);
    m.abs_mean_curvature_per_mm = mean(fields.curvature.mean);
    m.curvedness_per_mm = mean(fields.curvature.curvedness);
    m.sulcal_depth_mean_mm = mean(fields.sulcal_depth);
    m.sulcal_depth_max_mm = *std::max_element(fields.sulcal_depth.begin(), fields.sulcal_depth.end());
    m.sulcal_pits = static_cast<double>(extrema.pits.size());
    m.gyral_crowns = static_cast<double>(extrema.crowns.size());
    m.fold_wavelength_mm =
        curvature_wavelength(vertices, triangles, fields.curvature.mean, areas, options.least_wave_height_mm);
    m.asymmetry_area = sides.area;
    m.asymmetry_volume = sides.volume;
    return m;
}

} // namespace corticle::metrics
