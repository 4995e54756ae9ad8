// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/discretization.hpp"
#include "corticle/model/body.hpp"
#include "corticle/model/options.hpp"

#include <memory>

namespace corticle
{

/// The discretisation the options ask for, of a prepared body, which must outlive it.
std::unique_ptr<Discretization> make_discretization(const Body& body, const SimulationOptions& options);

} // namespace corticle
