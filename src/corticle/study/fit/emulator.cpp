// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/emulator.hpp"

#include "corticle/base/parallel.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace corticle::fit
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{

constexpr double slope_step = 0.01;

/// Correlations between targets of the errors of left-out runs, shrunk by what they owe to the number of runs: the
/// variance of a correlation r of n values is (1 - r²)² / (n - 1) (Schäfer & Strimmer 2005).
MatrixXd shrunk_correlation(std::span<const GaussianProcess> processes, Index targets)
{
    MatrixXd correlation = MatrixXd::Identity(targets, targets);
    const auto runs = static_cast<double>(processes.front().left_out_errors().size());
    double variances = 0.0;
    double squares = 0.0;
    for (Index j = 0; j < targets; ++j)
    {
        for (Index i = 0; i < j; ++i)
        {
            const VectorXd& a = processes[static_cast<std::size_t>(i)].left_out_errors();
            const VectorXd& b = processes[static_cast<std::size_t>(j)].left_out_errors();
            const double norms = std::sqrt(a.squaredNorm() * b.squaredNorm());
            const double found = norms > 0.0 ? a.dot(b) / norms : 0.0;
            variances += (1.0 - found * found) * (1.0 - found * found) / (runs - 1.0);
            squares += found * found;
            correlation(i, j) = found;
            correlation(j, i) = found;
        }
    }
    const double kept = squares > 0.0 ? std::max(0.0, 1.0 - variances / squares) : 0.0;
    correlation *= kept;
    correlation.diagonal().setOnes();
    return correlation;
}

} // namespace

Emulator::Emulator(std::span<const Evaluation> evaluations, std::span<const Quantity> quantities)
{
    std::vector<Point> points;
    std::vector<std::vector<double>> values(quantities.size());
    for (const Evaluation& one : evaluations)
    {
        // A point that was asked for twice is one run, and would count as two without scatter.
        if (!one.failure.empty() || std::ranges::find(points, one.u) != points.end())
        {
            continue;
        }
        points.push_back(one.u);
        for (std::size_t q = 0; q < quantities.size(); ++q)
        {
            values[q].push_back(one.predicted[q]);
        }
    }
    runs_ = points.size();
    assert(runs_ >= 2);
    const auto targets = std::ranges::count_if(quantities, [](const Quantity& one) { return one.value.has_value(); });
    observed_.resize(targets);
    observed_variance_.resize(targets);
    std::vector<std::optional<GaussianProcess>> learnt(quantities.size());
    parallel_blocks(
        std::ssize(learnt),
        [&](std::int64_t begin, std::int64_t)
        {
            const auto q = static_cast<std::size_t>(begin);
            learnt[q].emplace(points, values[q]);
        },
        1);
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        processes_.push_back(std::move(*learnt[q]));
        if (quantities[q].value)
        {
            observed_(static_cast<Index>(q)) = *quantities[q].value;
            observed_variance_(static_cast<Index>(q)) = quantities[q].sd * quantities[q].sd;
        }
    }
    correlation_ = shrunk_correlation(processes_, targets);
    correction_ = VectorXd::Zero(static_cast<Index>(quantities.size()));
    correction_variance_ = correction_;
}

Emulator::Predictions Emulator::predict(std::span<const double> u) const
{
    const auto count = static_cast<Index>(processes_.size());
    Predictions result{VectorXd(count), VectorXd(count)};
    for (Index q = 0; q < count; ++q)
    {
        const GaussianProcess::Prediction one = processes_[static_cast<std::size_t>(q)].predict(u);
        result.mean(q) = one.mean + correction_(q);
        result.variance(q) = one.variance + correction_variance_(q);
    }
    return result;
}

/// Of the emulator's errors of the targets.
MatrixXd Emulator::error_covariance(const Predictions& predictions) const
{
    const VectorXd deviations = predictions.variance.head(observed_.size()).cwiseSqrt();
    return deviations.asDiagonal() * correlation_ * deviations.asDiagonal();
}

VectorXd Emulator::variance_shares(std::span<const double> u) const
{
    const Index targets = observed_.size();
    const auto dimensions = static_cast<Index>(u.size());
    const MatrixXd errors = error_covariance(predict(u));
    MatrixXd covariance = errors;
    covariance.diagonal() += observed_variance_;
    MatrixXd slopes(targets, dimensions);
    for (Index k = 0; k < dimensions; ++k)
    {
        Point below(u.begin(), u.end());
        Point above = below;
        double& low = below[static_cast<std::size_t>(k)];
        double& high = above[static_cast<std::size_t>(k)];
        low = std::max(0.0, low - slope_step);
        high = std::min(1.0, high + slope_step);
        for (Index q = 0; q < targets; ++q)
        {
            const GaussianProcess& process = processes_[static_cast<std::size_t>(q)];
            slopes(q, k) = (process.mean(above) - process.mean(below)) / (high - low);
        }
    }
    const Eigen::LLT<MatrixXd> factor(covariance);
    const MatrixXd weighted = factor.solve(slopes);
    MatrixXd precision = slopes.transpose() * weighted;
    precision.diagonal().array() += 1.0 / even_variance;
    const MatrixXd variance = precision.llt().solve(MatrixXd::Identity(dimensions, dimensions));
    const MatrixXd gain = variance * weighted.transpose();
    return (gain * errors * gain.transpose()).diagonal().cwiseQuotient(variance.diagonal());
}

double Emulator::log_likelihood(std::span<const double> u) const
{
    const Index targets = observed_.size();
    const Predictions predictions = predict(u);
    MatrixXd covariance = error_covariance(predictions);
    covariance.diagonal() += observed_variance_;
    const Eigen::LLT<MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success)
    {
        return -std::numeric_limits<double>::max();
    }
    const VectorXd rest = factor.matrixL().solve(VectorXd(observed_ - predictions.mean.head(targets)));
    const MatrixXd lower = factor.matrixL();
    return -0.5 * rest.squaredNorm() - lower.diagonal().array().log().sum();
}

void Emulator::correct(std::span<const Evaluation> dear)
{
    const auto count = static_cast<Index>(processes_.size());
    std::vector<VectorXd> differences;
    for (const Evaluation& one : dear)
    {
        if (one.failure.empty())
        {
            VectorXd difference(count);
            for (Index q = 0; q < count; ++q)
            {
                const auto process = static_cast<std::size_t>(q);
                difference(q) = one.predicted[process] - processes_[process].mean(one.u);
            }
            differences.push_back(std::move(difference));
        }
    }
    if (differences.empty())
    {
        return;
    }
    const auto runs = static_cast<double>(differences.size());
    correction_.setZero();
    for (const VectorXd& difference : differences)
    {
        correction_ += difference / runs;
    }
    correction_variance_.setZero();
    for (const VectorXd& difference : differences)
    {
        correction_variance_ += (difference - correction_).cwiseAbs2() * (1.0 + 1.0 / runs) / std::max(1.0, runs - 1.0);
    }
    for (Index q = 0; runs < 2.0 && q < count; ++q)
    {
        const double scatter = processes_[static_cast<std::size_t>(q)].scatter();
        correction_variance_(q) = scatter * scatter;
    }
}

double chi_square(std::span<const double> predicted, std::span<const Quantity> quantities)
{
    double sum = 0.0;
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        if (quantities[q].value)
        {
            const double z = (predicted[q] - *quantities[q].value) / quantities[q].sd;
            sum += z * z;
        }
    }
    return sum;
}

} // namespace corticle::fit
