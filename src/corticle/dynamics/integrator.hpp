// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Positions [mm], velocities [mm per unit of time] and forces [mu_w mm²] of all particles at one time.
struct Motion
{
    std::vector<Vec3> x;
    std::vector<Vec3> v;
    std::vector<Vec3> force;
};

/// Energies of one step [mu_w mm³].
struct StepEnergies
{
    double kinetic = 0.0;     ///< at the end of the step
    double damped = 0.0;      ///< taken by the mass-proportional damping
    double stopped = 0.0;     ///< taken where the travel limit of contact stopped a particle
    std::int64_t limited = 0; ///< particles so stopped
};

/// One step of symplectic Euler with mass-proportional damping integrated exactly:
/// v' = (v + dt f/m) exp(-damping dt), x' = x + dt v'. A particle that would move farther than its travel limit
/// moves that far, and its velocity is shortened to match.
/// @param travel_limit  [mm], one per particle
StepEnergies advance(const Motion& from, std::span<const double> mass, std::span<const double> travel_limit, double dt,
                     double damping, Motion& to);

/// Largest step an explicit integrator may take, times a safety factor:
/// cfl · spacing / (largest of wave speed · g / smallest principal stretch).
/// @param stiffest_rate  that largest rate at the current state [mm per unit of time]
inline double critical_step(double cfl, double spacing, double stiffest_rate)
{
    return cfl * spacing / stiffest_rate;
}

} // namespace corticle
