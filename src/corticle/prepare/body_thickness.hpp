// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"

namespace corticle::prepare
{

/// Where the cortex is `thickness` thick by the case, in the reference state at growth time t [mm].
double thickness_at(const PreparationOptions& options, double thickness, double t);

/// Smallest thickness of the cortex during the run [mm in the reference state]; its mean where labels give it.
double least_thickness(const PreparationOptions& options, const model::Model& model);

/// Mean thickness of the cortex as the run begins, wherever it ends [mm in the reference state].
double mean_thickness(const PreparationOptions& options, const model::Model& model);

} // namespace corticle::prepare
