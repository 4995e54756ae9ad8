// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/tissue_term.hpp"
#include "corticle/model/model.hpp"
#include "corticle/model/options.hpp"
#include "corticle/model/state.hpp"

#include <memory>
#include <vector>

namespace corticle::model
{

/// The discretisation the options ask for. Refers to all three.
std::unique_ptr<mechanics::Discretization> make_discretization(const Model& model, const SimulationOptions& options,
                                                               const State& state);

/// The forces of a simulation besides those of the tissue. Refer to the model.
std::vector<std::unique_ptr<mechanics::ForceTerm>> make_terms(const Model& model, const SimulationOptions& options);

} // namespace corticle::model
