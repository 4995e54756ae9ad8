// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <string_view>

namespace corticle::metrics
{

/// 100 (b - a) / |a| [%]; 0 where both are equal, NaN where only a is 0 or one of them is not finite.
double percent_difference(double a, double b);

/// Is this measure a share or an asymmetry? They may be 0 and are compared by their difference, not in percent.
bool is_share(std::string_view key);

/// percent_difference where it says something: NaN for shares and asymmetries, and where a is near zero, below a
/// hundredth of b or a millionth of `scale`. @param scale  size of the measure, such as its largest value in a run
double telling_percent(std::string_view key, double a, double b, double scale = 0.0);

/// The value at `at` of a curve through (x, y), linear between its points; x ascends. NaN outside the curve.
double interpolate(std::span<const double> x, std::span<const double> y, double at);

/// A scalar at points of the reference configuration.
struct PointField
{
    std::span<const Vec3> origins;  ///< [mm]
    std::span<const double> values; ///< as many
    double spacing = 0.0;           ///< mean distance of the points [mm]
};

/// How far two fields differ.
struct FieldDifference
{
    bool is_interpolated = false; ///< false: both have the same points, in the same order
    double mean = 0.0;            ///< mean |a - b| (thesis eq. 27)
    double largest = 0.0;         ///< largest |a - b|
    double compared_share = 1.0;  ///< share of the points of both that have a counterpart in the other field
    /// Mean error of the interpolation itself: each point's value interpolated from the other points of its own field;
    /// 0 where none was needed.
    double interpolation_error = 0.0;
};

/// Mean difference of two fields, MD = mean |a_j - b_j| (thesis eq. 27).
///
/// Where both have the same reference points (to 1e-6 spacings) they are compared point by point. Otherwise each point
/// of either field is compared with the value of the other field interpolated there, and the means over the points of a
/// and over those of b are averaged, so that both fields count alike and exchanging them changes nothing. The
/// interpolation is Shepard's with a slope: the weights (1 - d / R)² / d² of the points nearer than R = 2 spacings
/// (Franke & Nielson 1980) give mean place and mean value, and a slope fitted with the same weights carries the value
/// from there to the point; the result stays within the values used. Points with nothing within R are left out; where
/// all are, the numbers are not numbers and compared_share is 0.
FieldDifference mean_difference(const PointField& a, const PointField& b);

/// A triangulated surface held elsewhere.
struct SurfaceView
{
    std::span<const Vec3> vertices; ///< [mm]
    std::span<const Triangle> triangles;
};

/// Distances between two surfaces [mm], of the vertices of each to the other surface, both ways together.
struct SurfaceDistance
{
    double mean = 0.0;          ///< weighted with the area about each vertex
    double percentile_95 = 0.0; ///< 95 % of the area (about the vertices) is at most this far from the other surface
    double hausdorff = 0.0;     ///< largest
};

/// Distances between two surfaces that are not empty; exchanging a and b changes nothing but round-off.
SurfaceDistance surface_distance(const SurfaceView& a, const SurfaceView& b);

} // namespace corticle::metrics
