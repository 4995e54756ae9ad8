// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/options.hpp"
#include "corticle/material/options.hpp"

namespace corticle::dynamics
{

/// What a step leaves behind that the rate of loading depends on.
struct LoadedStep
{
    double rate;           ///< of the step, dt/dtime [1/T]
    double t;              ///< at its end
    double growth_step;    ///< [t]
    bool has_folded;       ///< whether folds have appeared
    double kinetic_energy; ///< [mu_w mm³]
    double elastic_energy; ///< [mu_w mm³]
};

/// How fast growth goes on. Growth near that at which a flat cortex folds is passed slowly: an instability needs time
/// to grow. Once folds have appeared the rate is that at which the kinetic energy, which goes with its square, would be
/// a given share of the elastic one. A fixed time step keeps it at 1.
class Loading
{
  public:
    /// @param start  t at which the body is free of stress
    Loading(const DynamicsOptions& dynamics, const material::TissueOptions& tissue, double start);

    /// The rate of the next step [1/T].
    double next(const LoadedStep& step) const;

    /// Whether growth at t is near that at which a flat cortex folds.
    bool is_critical(double t) const;

  private:
    DynamicsOptions dynamics_;
    material::TissueOptions tissue_;
    double growth_at_start_;
    double critical_growth_;
};

} // namespace corticle::dynamics
