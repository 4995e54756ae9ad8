// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"
#include "corticle/mesh/share.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::dynamics
{

/// Positions [mm], velocities [mm per unit of time] and forces [mu_w mm²] of all particles at one time.
struct Motion
{
    std::vector<Vec3> x;
    std::vector<Vec3> v;
    std::vector<Vec3> force;
};

/// What a body moves in: mass-proportional drag on motion against a medium that may expand with the body.
struct Medium
{
    double damping = 0.0;   ///< [1 / time]
    double expansion = 0.0; ///< [1 / time]
    Vec3 centre{};          ///< that stays where it is [mm]

    Vec3 velocity(const Vec3& x) const { return expansion * (x - centre); }
};

/// Energies of one step [mu_w mm³].
struct StepEnergies
{
    double kinetic = 0.0;  ///< at the end of the step
    double relative = 0.0; ///< the same, of the motion against the medium
    double damped = 0.0;   ///< taken by the damping
    double carried = 0.0;  ///< work of the medium as it expands
    double longest = 0.0;  ///< way of a particle [mm]
};

/// One step of symplectic Euler with the damping integrated exactly, u the velocity of the medium at x:
/// v' = u + (v + dt f/m - u) exp(-damping dt), x' = x + dt v'.
/// @param share  whose particles are moved; the energies are of all ranks
StepEnergies advance(const Motion& from, std::span<const double> mass, double dt, const Medium& medium,
                     const Share& share, Motion& to);
inline StepEnergies advance(const Motion& from, std::span<const double> mass, double dt, const Medium& medium,
                            Motion& to)
{
    return advance(from, mass, dt, medium, Share(std::ssize(mass)), to);
}

/// Kinetic energy, whole and against the medium.
struct KineticEnergies
{
    double whole = 0.0;
    double relative = 0.0;
};
KineticEnergies kinetic_energies(const Motion& motion, std::span<const double> mass, const Medium& medium,
                                 const Share& share);
inline KineticEnergies kinetic_energies(const Motion& motion, std::span<const double> mass, const Medium& medium)
{
    return kinetic_energies(motion, mass, medium, Share(std::ssize(mass)));
}

/// Largest step an explicit integrator may take, times a safety factor:
/// cfl · spacing / (largest of wave speed · g / smallest principal stretch).
/// @param stiffest_rate  that largest rate at the current state [mm per unit of time]
inline double critical_step(double cfl, double spacing, double stiffest_rate)
{
    return cfl * spacing / stiffest_rate;
}

/// Largest step that the springs of contact allow beside the tissue. Symplectic Euler is stable where w dt < 2; the
/// tissue takes w dt = 0.8 of it at the usual cfl of 0.6, and squares add up.
/// @param largest_rate  largest frequency w of the springs [1 / time]
inline double contact_step(double cfl, double largest_rate)
{
    constexpr double share = 2.5;
    return share * cfl / largest_rate;
}

} // namespace corticle::dynamics
