// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"

namespace corticle::model
{

/// Cauchy stress at a node from the deformation gradient there, by the law of the run's formulation [mu_w].
Mat3 cauchy_stress_at(const Simulation& simulation, std::size_t node, const Mat3& F);

} // namespace corticle::model
