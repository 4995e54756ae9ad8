// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/surrogate/gaussian_process.hpp"

#include <functional>

namespace corticle::sensitivity
{

/// Shares of the variance of a function of even coordinates of the unit cube (Sobol 1993).
struct SobolIndices
{
    std::vector<double> first; ///< of each coordinate alone
    std::vector<double> total; ///< of it and all it does together with others
    double variance = 0.0;
};

/// By two sets of evenly spread points and those between them: first indices as Saltelli et al. 2010, total ones as
/// Jansen 1999.
/// @param samples  points of each set
SobolIndices sobol_indices(const std::function<double(std::span<const double>)>& function, std::size_t dimensions,
                           std::size_t samples, std::uint64_t seed);

/// The same of the function that some runs give, by a Gaussian process.
struct EmulatedIndices
{
    SobolIndices indices;
    std::vector<double> first_error; ///< half of the 90 % intervals: what the choice of the runs decides (jackknife)
    std::vector<double> total_error;
    double predictivity = 0.0;  ///< Q² of the Gaussian process
    double scatter_share = 0.0; ///< of the variance of runs, what no parameter explains
};

EmulatedIndices emulated_indices(std::span<const fit::Point> points, std::span<const double> values,
                                 std::size_t samples, std::uint64_t seed);

} // namespace corticle::sensitivity
