// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/discretization.hpp"
#include "corticle/model/model.hpp"
#include "corticle/model/options.hpp"
#include "corticle/model/state.hpp"

#include <memory>

namespace corticle
{

/// The discretisation the options ask for, of a prepared body, which must outlive it.
std::unique_ptr<Discretization> make_discretization(const Model& model, const SimulationOptions& options,
                                                    const State& state);

} // namespace corticle
