// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/evaluator.hpp"

namespace corticle::fit
{

/// evaluations.csv: a row for each run in the order in which they were asked for. No times: made again, it has the same
/// bytes.
/// @param misfits  as many as evaluations; empty: no column
std::string evaluations_table(const ParameterSpace& space, std::span<const Quantity> quantities,
                              std::span<const Evaluation> evaluations, std::span<const double> misfits);

} // namespace corticle::fit
