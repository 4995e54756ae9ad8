// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/integrator.hpp"

#include <functional>
#include <optional>

namespace corticle::dynamics
{

/// The classical Runge-Kutta method of fourth order for x'' = f(x, x', t) / m - damping (x' - u),
/// u the velocity of the medium.
class RungeKutta4
{
  public:
    /// Sets stage.force at the positions and velocities of the stage, `part` of the step from its start; false when
    /// they are invalid.
    using Evaluate = std::function<bool(Motion& stage, double part)>;

    /// One step of length dt from `from`, whose forces are known; three evaluations. The forces of `to` are left to the
    /// caller. @return the energies, or nothing where a stage is invalid
    /// @param share  whose particles are moved; the energies are of all ranks
    std::optional<StepEnergies> advance(const Motion& from, std::span<const double> mass, double dt,
                                        const Medium& medium, const Share& share, const Evaluate& evaluate, Motion& to);
    std::optional<StepEnergies> advance(const Motion& from, std::span<const double> mass, double dt,
                                        const Medium& medium, const Evaluate& evaluate, Motion& to)
    {
        return advance(from, mass, dt, medium, Share(std::ssize(mass)), evaluate, to);
    }

  private:
    std::vector<Vec3> velocity_sum_; ///< v1 + 2 v2 + 2 v3 + v4
    std::vector<Vec3> rate_sum_;     ///< the same of the accelerations
};

} // namespace corticle::dynamics
