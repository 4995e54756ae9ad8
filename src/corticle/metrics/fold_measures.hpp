// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/asymmetry.hpp"
#include "corticle/metrics/surface/curvature.hpp"
#include "corticle/metrics/surface/zilles.hpp"

#include <optional>
#include <string_view>

namespace corticle::metrics
{

/// What sulcal depth and local gyrification are measured against.
enum class OuterSurface
{
    hull,  ///< convex hull
    closed ///< a ball rolled around the body: follows concavities wider than the ball
};

/// How folds are measured. Lengths that the literature gives for adult brains shrink with the body: times the radius of
/// the sphere of equal volume over 67 mm, that of a brain of 1.26 l.
struct FoldOptions
{
    SliceOptions slices;
    OuterSurface outer = OuterSurface::hull;
    double adult_closing_mm = 15.0;     ///< radius of the ball of OuterSurface::closed (Schaer et al. 2008)
    double adult_ball_mm = 25.0;        ///< radius of the ball of local gyrification (Schaer et al. 2008)
    double adult_ridge_height_mm = 2.5; ///< between sulcal pits (Im et al. 2010)
    double least_wave_height_mm = 0.0;  ///< root mean square, of waves that count as folds
    std::optional<Plane> midplane;      ///< of the asymmetry; that of the surface itself if there is none
};

/// Measures at the vertices of a closed surface.
struct FoldFields
{
    Curvature curvature;
    std::vector<double> sulcal_depth;       ///< below the outer surface [mm]
    std::vector<double> local_gyrification; ///< against the outer surface [-]
};

FoldFields fold_fields(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                       const FoldOptions& options = {});

/// Measures of the folds of a closed surface; means are weighted with area.
struct FoldMeasures
{
    double gi_zilles = 0.0;                 ///< of slices, totals over totals
    double gi_local_mean = 0.0;             ///< local gyrification index
    double abs_mean_curvature_per_mm = 0.0; ///< mean of |H|
    double curvedness_per_mm = 0.0;         ///< mean
    double sulcal_depth_mean_mm = 0.0;
    double sulcal_depth_max_mm = 0.0;
    double sulcal_pits = 0.0;        ///< number
    double gyral_crowns = 0.0;       ///< number
    double fold_wavelength_mm = 0.0; ///< dominant wavelength of H along the surface itself; 0: no folds
    double asymmetry_area = 0.0;     ///< left less right over their mean
    double asymmetry_volume = 0.0;
};

FoldMeasures measure_folds(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           const FoldFields& fields, const FoldOptions& options = {});

} // namespace corticle::metrics
