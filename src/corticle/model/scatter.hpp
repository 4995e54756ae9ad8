// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/share.hpp"
#include "corticle/model/model.hpp"
#include "corticle/model/options.hpp"
#include "corticle/model/state.hpp"

namespace corticle::model
{

/// From the model that rank 0 has prepared, to every rank its part of it: all of nodes, surface and tissue, and its own
/// share of pairs and fits. Those of others are gone from rank 0 too. Collective. @return the share of this rank
Share scatter(Model& model, const SimulationOptions& options, const Communicator& ranks);

/// The state that rank 0 has read from a checkpoint, to all. Collective.
void broadcast(State& state, const Communicator& ranks);

} // namespace corticle::model
