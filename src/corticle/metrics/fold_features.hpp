// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/comparison.hpp"

#include <span>
#include <vector>

// What folds are compared by, and how alike two patterns are.

namespace corticle::metrics
{

/// What is known at the vertices of a surface, and its sulcal pits.
struct FoldFeatures
{
    std::vector<double> depth;     ///< below the convex hull [mm]
    std::vector<double> curvature; ///< mean, smoothed; negative in sulci [1/mm]
    std::vector<Vec3> pits;
};
FoldFeatures fold_features(const SurfaceView& surface);

/// What a cubic polynomial of `known` does not explain; weighted with area.
std::vector<double> taken_out(std::span<const double> values, std::span<const double> known,
                              std::span<const double> weights);

/// Pearson's, weighted with area; 0 where one side is constant.
double correlation(std::span<const double> a, std::span<const double> b, std::span<const double> weights);

/// Overlap of the concave areas of two curvatures: twice the common over the sum; 0 where nothing is concave.
double sulcal_dice(std::span<const double> a, std::span<const double> b, std::span<const double> weights);

} // namespace corticle::metrics
