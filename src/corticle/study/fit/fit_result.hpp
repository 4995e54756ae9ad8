// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/emulator.hpp"
#include "corticle/study/fit/fit_file.hpp"
#include "corticle/study/fit/posterior.hpp"

#include <optional>

// What a fit found, and the files that say it.

namespace corticle::fit
{

/// A number with what the draws of the posterior say of it.
struct Interval
{
    double median = 0.0;
    double low = 0.0; ///< 90 % of the draws lie between
    double high = 0.0;
    double sd = 0.0;
};

/// What is known of the parameters once there is an emulator.
struct Knowledge
{
    Emulator emulator;
    Point mode;
    Draws draws;
    std::vector<Interval> parameters; ///< in their units
    std::vector<Interval> together;   ///< the same, with 90 % of the draws within all of them at once
    std::vector<double> narrowed;     ///< sd over that of the prior, of each coordinate
    Eigen::VectorXd of_emulator;      ///< share of the variance of each coordinate that is the emulator's
    Eigen::MatrixXd correlations;     ///< of the coordinates
    std::vector<Interval> certain;    ///< each quantity: what the parameters leave open
    std::vector<Interval> expected;   ///< each quantity: of a run, the emulator's error and scatter included
};

struct FitResult
{
    std::vector<Evaluation> evaluations; ///< in the order in which they were asked for
    std::size_t best = 0;                ///< of them, the nearest to the targets of the dearest that there are
    bool has_best = false;
    std::optional<Knowledge> knowledge;
};

/// -2 log(likelihood prior) of an evaluation, but for a constant; NaN where it failed.
double misfit(const FitFile& fit, const Evaluation& evaluation);

/// Draws, intervals and correlations of an emulator.
Knowledge learn(const FitFile& fit, Emulator emulator, std::span<const Point> starts);

/// The evaluation to be called the best, if any succeeded.
std::optional<std::size_t> best_evaluation(const FitFile& fit, std::span<const Evaluation> evaluations);

std::string fit_json(const FitFile& fit, const FitResult& result);
std::string fit_markdown(const FitFile& fit, const FitResult& result);

/// Name and text of each plot.
std::vector<std::pair<std::string, std::string>> fit_plots(const FitFile& fit, const FitResult& result);

} // namespace corticle::fit
