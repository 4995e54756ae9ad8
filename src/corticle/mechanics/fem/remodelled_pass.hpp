// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/options.hpp"

#include <memory>

namespace corticle::fem
{

class ForcePass;

/// The pass of tissue with a history (Tissue::remodelling), compiled apart from those without.
std::unique_ptr<const ForcePass> remodelled_force_pass(const material::TissueOptions& options);

} // namespace corticle::fem
