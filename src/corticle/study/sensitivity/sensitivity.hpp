// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/fit.hpp"

namespace corticle::sensitivity
{

/// What `corticle sensitivity` was asked for: as of a fit.
using SensitivityRequest = fit::FitRequest;

/// Says which parameters of a case matter for measures of its runs: Morris screening, and Sobol indices by a Gaussian
/// process of some runs. Writes evaluations.csv, sensitivity.json, sensitivity.md and plots/*.svg. Made again it finds
/// the runs that were finished.
/// @throws InputError before anything is written; RunError when too many runs fail
model::RunStatus analyze(const SensitivityRequest& request);

} // namespace corticle::sensitivity
