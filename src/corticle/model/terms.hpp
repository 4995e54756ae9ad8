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

/// Histories of the material points, or null where the options ask for none.
std::unique_ptr<mechanics::Remodelling> make_remodelling(const Model& model, const SimulationOptions& options);

/// Whether the method the options ask for shares its work among ranks: TL-SPH does. Those that do not are evaluated by
/// every rank alike.
bool shares_work(const SimulationOptions& options);

/// Whose particles this rank works on.
Share make_share(const Model& model, const SimulationOptions& options, const Communicator& ranks);

/// The discretisation the options ask for. Refers to all of them. @param remodelling  null: none
std::unique_ptr<mechanics::Discretization> make_discretization(const Model& model, const SimulationOptions& options,
                                                               const State& state,
                                                               const mechanics::Remodelling* remodelling,
                                                               const Share& share);

/// Nodes held by supports.
std::vector<std::int32_t> held_nodes(const Model& model, const SimulationOptions& options);
/// Nodes whose motion terms other than the tissue look at.
std::vector<std::int32_t> nodes_of_terms(const Model& model, const SimulationOptions& options);

/// The forces of a simulation besides those of the tissue. Refer to the model.
std::vector<std::unique_ptr<mechanics::ForceTerm>> make_terms(const Model& model, const SimulationOptions& options,
                                                              const Share& share);

} // namespace corticle::model
