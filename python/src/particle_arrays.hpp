// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"

#include <vector>

// What Python can see of the particles of a simulation at its present state, one value each.

namespace corticle::python
{

std::vector<double> volume_ratios_of(const model::Simulation& simulation);
/// Cauchy stress [mu_w].
std::vector<Mat3> stress_of(const model::Simulation& simulation);
/// Tangential growth g_t [-].
std::vector<double> growth_of(const model::Simulation& simulation);
/// Growth along the normal g_r [-].
std::vector<double> radial_growth_of(const model::Simulation& simulation);

} // namespace corticle::python
