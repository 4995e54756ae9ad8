// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/surrogate/gaussian_process.hpp"

#include "corticle/study/surrogate/minimize.hpp"

#include <Eigen/Cholesky>

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace corticle::fit
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Bounds of what is sought, as the coordinates run over [0, 1].
constexpr double shortest_length = 0.1;
constexpr double longest_length = 20.0;
constexpr double least_nugget = 1e-8;
constexpr double largest_nugget = 10.0;
constexpr int evaluations_per_number = 60;
constexpr double least_scale = 1e-300; // of values that are all the same

/// The largest degree for which there are at least twice as many points as terms.
int degree_for(Index points, Index dimensions)
{
    const Index linear = 1 + dimensions;
    const Index quadratic = linear + dimensions * (dimensions + 1) / 2;
    return points >= 2 * quadratic ? 2 : points >= 2 * linear ? 1 : 0;
}

double from_unit(double u, double low, double high)
{
    return low * std::pow(high / low, u);
}

/// exp(-1/2 |scaled difference|²).
double correlation(const VectorXd& inverse_lengths, const Eigen::Ref<const VectorXd>& a,
                   const Eigen::Ref<const VectorXd>& b)
{
    return std::exp(-0.5 * (a - b).cwiseProduct(inverse_lengths).squaredNorm());
}

VectorXd solve_lower(const MatrixXd& factor, const VectorXd& right)
{
    return factor.triangularView<Eigen::Lower>().solve(right);
}

} // namespace

/// One choice of lengths and nugget, and what follows from it.
class GaussianProcess::Fitting
{
  public:
    Fitting(const GaussianProcess& of, const Shape& shape)
    {
        const Index count = of.points_.cols();
        MatrixXd covariance(count, count);
        for (Index j = 0; j < count; ++j)
        {
            for (Index i = j; i < count; ++i)
            {
                covariance(i, j) = correlation(shape.inverse_lengths, of.points_.col(i), of.points_.col(j));
            }
            covariance(j, j) += shape.nugget + least_nugget;
        }
        const Eigen::LLT<MatrixXd> whole(covariance.selfadjointView<Eigen::Lower>());
        is_valid = whole.info() == Eigen::Success;
        if (!is_valid)
        {
            return;
        }
        factor = whole.matrixL();
        trend_solve = factor.triangularView<Eigen::Lower>().solve(of.terms_);
        value_solve = solve_lower(factor, of.values_);
        const Index terms = of.terms_.cols();
        MatrixXd normal(terms, terms);
        for (Index j = 0; j < terms; ++j)
        {
            for (Index i = j; i < terms; ++i)
            {
                normal(i, j) = trend_solve.col(i).dot(trend_solve.col(j));
            }
        }
        const Eigen::LLT<MatrixXd> trend(normal.selfadjointView<Eigen::Lower>());
        is_valid = trend.info() == Eigen::Success;
        if (!is_valid)
        {
            return;
        }
        trend_factor = trend.matrixL();
        coefficients = trend.solve(VectorXd(trend_solve.transpose() * value_solve));
        const VectorXd rest = value_solve - trend_solve * coefficients;
        const double freedom = static_cast<double>(count - terms);
        variance = rest.squaredNorm() / freedom;
        likelihood = -0.5 * freedom * std::log(std::max(variance, std::numeric_limits<double>::min())) -
                     factor.diagonal().array().log().sum() - trend_factor.diagonal().array().log().sum();
    }

    bool is_valid = false;
    MatrixXd factor;
    MatrixXd trend_solve;
    MatrixXd trend_factor;
    VectorXd value_solve;
    VectorXd coefficients;
    double variance = 0.0;
    double likelihood = -std::numeric_limits<double>::infinity();
};

GaussianProcess::GaussianProcess(std::span<const Point> points, std::span<const double> values)
{
    assert(points.size() == values.size() && points.size() >= 2);
    const auto count = static_cast<Index>(points.size());
    const auto dimensions = static_cast<Index>(points.front().size());
    points_.resize(dimensions, count);
    values_.resize(count);
    for (Index i = 0; i < count; ++i)
    {
        points_.col(i) = Eigen::Map<const VectorXd>(points[static_cast<std::size_t>(i)].data(), dimensions);
        values_(i) = values[static_cast<std::size_t>(i)];
    }
    offset_ = values_.mean();
    values_.array() -= offset_;
    scale_ = std::max(std::sqrt(values_.squaredNorm() / static_cast<double>(count)), least_scale);
    values_ /= scale_;
    degree_ = degree_for(count, dimensions);
    for (Index i = 0; i < count; ++i)
    {
        const VectorXd terms = trend_terms({points_.col(i).data(), static_cast<std::size_t>(dimensions)});
        terms_.conservativeResize(count, terms.size());
        terms_.row(i) = terms.transpose();
    }
    settle(find_shape());
}

VectorXd GaussianProcess::trend_terms(std::span<const double> at) const
{
    std::vector<double> terms{1.0};
    for (std::size_t i = 0; degree_ >= 1 && i < at.size(); ++i)
    {
        terms.push_back(at[i] - 0.5);
        for (std::size_t j = 0; degree_ >= 2 && j <= i; ++j)
        {
            terms.push_back((at[i] - 0.5) * (at[j] - 0.5));
        }
    }
    return Eigen::Map<const VectorXd>(terms.data(), static_cast<Index>(terms.size()));
}

GaussianProcess::Shape GaussianProcess::find_shape() const
{
    const Index dimensions = points_.rows();
    const auto shape_at = [&](std::span<const double> u)
    {
        Shape shape{VectorXd(dimensions), from_unit(u[u.size() - 1], least_nugget, largest_nugget)};
        for (Index k = 0; k < dimensions; ++k)
        {
            shape.inverse_lengths(k) = 1.0 / from_unit(u[static_cast<std::size_t>(k)], shortest_length, longest_length);
        }
        return shape;
    };
    const auto unlikelihood = [&](std::span<const double> u)
    {
        const double likelihood = Fitting(*this, shape_at(u)).likelihood;
        return std::isfinite(likelihood) ? -likelihood : 1e30;
    };
    // A smooth function with little scatter, a rough one, and one that is mostly scatter.
    constexpr std::array<std::array<double, 2>, 3> starts{{{0.5, 0.3}, {0.3, 0.2}, {0.6, 0.8}}};
    Minimum best{{}, std::numeric_limits<double>::infinity()};
    for (const auto& [length, nugget] : starts)
    {
        Point start(static_cast<std::size_t>(dimensions), length);
        start.push_back(nugget);
        const Minimum found = minimize(
            unlikelihood, start, {"LN_SBPLX", evaluations_per_number * static_cast<int>(dimensions + 1), 1e-3, 0.2, 1});
        best = found.value < best.value ? found : best;
    }
    return shape_at(best.at);
}

void GaussianProcess::settle(const Shape& shape)
{
    const Fitting fitting(*this, shape);
    assert(fitting.is_valid);
    shape_ = shape;
    variance_ = fitting.variance;
    factor_ = fitting.factor;
    trend_solve_ = fitting.trend_solve;
    trend_factor_ = fitting.trend_factor;
    coefficients_ = fitting.coefficients;
    const VectorXd rest = fitting.value_solve - fitting.trend_solve * fitting.coefficients;
    weights_ = factor_.transpose().triangularView<Eigen::Upper>().solve(rest);
    // Dubrule 1983: with Q = K^-1 - K^-1 F (F^T K^-1 F)^-1 F^T K^-1 the error of the i-th value is (Q y)_i / Q_ii.
    const Index count = points_.cols();
    left_out_errors_.resize(count);
    for (Index i = 0; i < count; ++i)
    {
        const VectorXd solved = solve_lower(factor_, VectorXd::Unit(count, i));
        const VectorXd trend = solve_lower(trend_factor_, VectorXd(trend_solve_.transpose() * solved));
        left_out_errors_(i) = scale_ * weights_(i) / (solved.squaredNorm() - trend.squaredNorm());
    }
}

VectorXd GaussianProcess::covariance_to(std::span<const double> at) const
{
    const Eigen::Map<const VectorXd> place(at.data(), points_.rows());
    VectorXd covariance(points_.cols());
    for (Index i = 0; i < points_.cols(); ++i)
    {
        covariance(i) = correlation(shape_.inverse_lengths, points_.col(i), place);
    }
    return covariance;
}

double GaussianProcess::mean(std::span<const double> at) const
{
    return offset_ + scale_ * (trend_terms(at).dot(coefficients_) + covariance_to(at).dot(weights_));
}

GaussianProcess::Prediction GaussianProcess::predict(std::span<const double> at) const
{
    const VectorXd covariance = covariance_to(at);
    const VectorXd terms = trend_terms(at);
    const VectorXd solved = solve_lower(factor_, covariance);
    const VectorXd trend = solve_lower(trend_factor_, VectorXd(terms - trend_solve_.transpose() * solved));
    const double relative = 1.0 + shape_.nugget - solved.squaredNorm() + trend.squaredNorm();
    return {offset_ + scale_ * (terms.dot(coefficients_) + covariance.dot(weights_)),
            scale_ * scale_ * variance_ * std::max(relative, 0.0)};
}

double GaussianProcess::predictivity() const
{
    if (scale_ <= least_scale)
    {
        return 1.0;
    }
    const double error = left_out_errors_.squaredNorm() / static_cast<double>(left_out_errors_.size());
    return 1.0 - error / (scale_ * scale_);
}

double GaussianProcess::scatter() const
{
    return scale_ * std::sqrt(variance_ * shape_.nugget);
}

} // namespace corticle::fit
