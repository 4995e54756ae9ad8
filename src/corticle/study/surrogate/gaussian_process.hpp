// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/surrogate/design.hpp"

#include <Eigen/Core>

#include <span>

namespace corticle::fit
{

/// A function of the unit cube that is known at some points, with scatter: the polynomial that the number of points
/// allows (of degree 0, 1 or 2) and a Gaussian process about it (universal kriging; Rasmussen & Williams 2006, section
/// 2.7). Its covariance is s² (exp(-1/2 sum ((x_k - x'_k) / l_k)²) + nugget δ); the lengths l_k and the nugget are
/// those of the largest restricted likelihood, s² follows.
class GaussianProcess
{
  public:
    struct Prediction
    {
        double mean = 0.0;
        double variance = 0.0; ///< of a new value there, its scatter included
    };

    /// @param points  at least two, of the same number of coordinates   @param values  as many
    GaussianProcess(std::span<const Point> points, std::span<const double> values);

    double mean(std::span<const double> at) const;
    Prediction predict(std::span<const double> at) const;

    /// Of each known value, its difference from what the others predict.
    const Eigen::VectorXd& left_out_errors() const { return left_out_errors_; }
    /// 1 - mean squared left-out error over the variance of the values: 1 is perfect, 0 no better than their mean.
    double predictivity() const;
    /// Standard deviation of the scatter between values at the same place.
    double scatter() const;

  private:
    struct Shape
    {
        Eigen::VectorXd inverse_lengths;
        double nugget = 0.0;
    };
    class Fitting;

    Shape find_shape() const;
    void settle(const Shape& shape);
    Eigen::VectorXd trend_terms(std::span<const double> at) const;
    Eigen::VectorXd covariance_to(std::span<const double> at) const;

    Eigen::MatrixXd points_; ///< one column a point
    Eigen::VectorXd values_; ///< less their mean, over their standard deviation
    double offset_ = 0.0;
    double scale_ = 1.0;
    int degree_ = 0; ///< of the polynomial
    Shape shape_;
    double variance_ = 0.0; ///< s², of the scaled values
    Eigen::MatrixXd terms_;
    Eigen::MatrixXd factor_;      ///< lower, of the covariance over s²
    Eigen::MatrixXd trend_solve_; ///< factor^-1 terms
    Eigen::MatrixXd trend_factor_;
    Eigen::VectorXd coefficients_; ///< of the polynomial
    Eigen::VectorXd weights_;      ///< covariance^-1 (values - polynomial)
    Eigen::VectorXd left_out_errors_;
};

} // namespace corticle::fit
