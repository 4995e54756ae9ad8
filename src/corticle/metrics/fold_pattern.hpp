// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/metrics/comparison.hpp"

#include <string>

namespace corticle::metrics
{

/// x -> scale R x + shift.
struct Similarity
{
    double scale = 1.0;
    Mat3 rotation = Mat3::identity();
    Vec3 shift; ///< [mm]

    Vec3 operator()(const Vec3& x) const { return scale * (rotation * x) + shift; }
};

/// Brings a surface onto another: equal volumes, equal centroids, then turns and shifts by iterated closest points
/// (Besl & McKay 1992).
/// @param residual_mm  receives the root mean square distance of vertices to the other surface
Similarity align(const SurfaceView& moving, const SurfaceView& target, double* residual_mm = nullptr);

/// How far folds are at the right place. The shape of the whole brain decides most of any plain correlation, so what is
/// known from the first body, as a cubic polynomial, is taken out of both sides first.
struct PatternScore
{
    std::string name;       ///< "run", "first body", "mirrored", "turned by 15 degrees", ...
    double depth = 0.0;     ///< partial correlation of the depth below the hull [-]
    double curvature = 0.0; ///< partial correlation of the mean curvature [-]
    double dice = 0.0;      ///< overlap of the sulcal (concave) area, twice the common over the sum [-]
    double pits_5mm = 0.0;  ///< share of the real sulcal pits with a predicted one within 5 mm
    double pits_10mm = 0.0; ///< within 10 mm
};

struct FoldPattern
{
    Similarity alignment;
    double residual_mm = 0.0;
    double plain_depth = 0.0;         ///< correlation of the depth as it is [-]
    double trivial_depth = 0.0;       ///< the same, of the first body brought to the size
    std::vector<PatternScore> scores; ///< run, then the controls: first body, mirrored, turned
};

/// @param first  the body as it was before it folded   @param grown  the same body now: same triangles
/// @param target  the real surface
FoldPattern fold_pattern(const SurfaceView& first, const SurfaceView& grown, const SurfaceView& target);

} // namespace corticle::metrics
