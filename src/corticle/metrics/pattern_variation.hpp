// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/comparison.hpp"

#include <span>
#include <vector>

namespace corticle::metrics
{

/// How alike several patterns are, two by two: correlations of what the first body does not explain [-]. Their mean is
/// the share of the pattern's variance that all have in common.
struct PatternAgreement
{
    double mean = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
};

/// The same body folded several times, at its vertices.
struct PatternVariation
{
    std::vector<double> depth_mean;     ///< below the convex hull [mm]
    std::vector<double> depth_sd;       ///< standard deviation between the surfaces [mm]
    std::vector<double> curvature_mean; ///< mean curvature, smoothed [1/mm]
    std::vector<double> sulcal_share;   ///< share of the surfaces that are concave here
    PatternAgreement depth;
    PatternAgreement curvature;
    PatternAgreement dice; ///< overlap of concave areas
};

/// @param first    the body before it folds
/// @param surfaces  two or more folded ones, with the triangles of the first
PatternVariation pattern_variation(const SurfaceView& first, std::span<const SurfaceView> surfaces);

} // namespace corticle::metrics
