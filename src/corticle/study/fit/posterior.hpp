// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/surrogate/design.hpp"

#include <Eigen/Core>

#include <functional>
#include <span>

namespace corticle::fit
{

using LogDensity = std::function<double(std::span<const double>)>;

/// The point of the unit cube where a density is largest: DIRECT over the cube, then Subplex from there and from each
/// of `starts`.
Point find_mode(const LogDensity& density, std::span<const Point> starts);

/// Draws from a density over the unit cube.
struct Draws
{
    std::vector<Point> points;  ///< of all chains, one after the other
    double acceptance = 1.0;    ///< of proposed steps
    std::vector<double> mixing; ///< of each coordinate: split R-hat (Gelman et al. 2013); 1: the chains agree
    bool is_laplace = false;
};

/// Random-walk Metropolis in four chains from about the mode. The first part of each, which is not kept, learns how
/// far to step (Haario et al. 2001), from the curvature at the mode on. A seed gives the same draws.
/// @param density  called from several threads
Draws walk(const LogDensity& density, const Point& mode, int count, std::uint64_t seed);

/// Draws from the normal density with the curvature of `density` at its mode, cut to the cube. Where the curvature says
/// nothing (a mode at a bound, a flat direction) the variance is that of the even density.
Draws laplace(const LogDensity& density, const Point& mode, int count, std::uint64_t seed);

/// Of values the share `level` of which lies below.
double quantile(std::vector<double> values, double level);

/// The share of draws that must lie within an interval of each coordinate, from rank to rank alike, so that `level` of
/// them lie within all intervals at once (Besag, Green, Higdon & Mengersen 1995).
double level_of_each(std::span<const Point> points, double level);

/// Correlations of the coordinates of points.
Eigen::MatrixXd correlations(std::span<const Point> points);

} // namespace corticle::fit
