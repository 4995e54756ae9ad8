// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/integrator.hpp"
#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/force_term.hpp"

#include <cstdint>

namespace corticle::model
{

/// Energy balance of a run: what went in and what was taken out, summed over its steps [mu_w mm³].
struct EnergyBalance
{
    double growth_work = 0.0; ///< put in by growth
    double dissipated = 0.0;  ///< taken by damping and by the travel limit of contact
};

/// All that changes as a run goes on. With the case a checkpoint of it is enough: forces, step and tissue follow.
struct State
{
    dynamics::Motion motion;
    material::TissueState nodes;    ///< the tissue at the nodes at t
    material::TissueState elements; ///< at the elements, where there are any
    double t = 0.0;                 ///< growth time [-]
    std::int64_t steps = 0;
    std::int64_t rejected_steps = 0;
    double step_scale = 1.0;     ///< 1, or what rejections have left of it; grows back
    double loading_rate = 1.0;   ///< dt/dtime in units of 1/T
    double kinetic_energy = 0.0; ///< [mu_w mm³]
    EnergyBalance energy_balance;
    mechanics::TravelTaken travel_taken; ///< in all steps so far
    mechanics::History history;          ///< what terms carry from step to step
    double lowest_gi_sphere = 1e300;     ///< lowest sphere index so far
    double onset_t = -1.0; ///< first t at which the sphere index stands 0.01 above its lowest; negative if not yet
};

} // namespace corticle::model
