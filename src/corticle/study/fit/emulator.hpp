// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/evaluator.hpp"
#include "corticle/study/surrogate/gaussian_process.hpp"

namespace corticle::fit
{

/// The numbers that runs predict, as functions of the parameters learnt from some runs. The first `targets` of them
/// are compared with what was observed.
class Emulator
{
  public:
    /// @param evaluations  those that failed are left out; the others are at least two
    Emulator(std::span<const Evaluation> evaluations, std::span<const Quantity> quantities);

    struct Predictions
    {
        Eigen::VectorXd mean;
        Eigen::VectorXd variance; ///< of what a run there would give
    };
    Predictions predict(std::span<const double> u) const;

    /// log p(observed | u): normal, with the variance of the observation, and of the emulator with the correlations
    /// that its left-out errors have between targets (shrunk towards none by what few runs leave open).
    double log_likelihood(std::span<const double> u) const;

    /// What share of the variance of each parameter the emulator's own errors make there, not the observations: with
    /// the derivatives of the predictions, and the even density over the cube before the targets.
    Eigen::VectorXd variance_shares(std::span<const double> u) const;

    /// Additive correction of every prediction, learnt from dearer runs at some points: the mean of what they give more
    /// than the emulator expects there; how much that varies (with one run: the scatter) is added to the variance.
    void correct(std::span<const Evaluation> dear);

    const std::vector<GaussianProcess>& processes() const { return processes_; }
    const Eigen::VectorXd& correction() const { return correction_; }
    const Eigen::VectorXd& correction_variance() const { return correction_variance_; }
    std::size_t runs() const { return runs_; }

  private:
    Eigen::MatrixXd error_covariance(const Predictions& predictions) const;

    std::vector<GaussianProcess> processes_;
    Eigen::VectorXd observed_;
    Eigen::VectorXd observed_variance_;
    Eigen::MatrixXd correlation_; ///< of the emulator's errors between targets
    Eigen::VectorXd correction_;
    Eigen::VectorXd correction_variance_;
    std::size_t runs_ = 0;
};

/// Sum over the targets of ((predicted - observed) / sd)².
double chi_square(std::span<const double> predicted, std::span<const Quantity> quantities);

} // namespace corticle::fit
