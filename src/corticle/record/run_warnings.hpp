// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measures.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace corticle::record
{

/// What is wrong with the state of a run at an output time.
struct RunWarning
{
    std::string_view kind; ///< key of the measure that shows it: the terminal hears of each kind once
    std::string text;      ///< one line
};

/// What the measures of a run are held against.
struct RunSize
{
    double start_t = 0.0; ///< at which growth sets in [t]
    double nodes = 1.0;   ///< particles, or nodes of tets
    double elements = 0.0;
};
RunSize size_of_run(const model::Simulation& simulation);

/// A line on each measure that says that the folds are not those of soft tissue in equilibrium, or that the
/// discretisation has broken.
std::vector<RunWarning> run_warnings(const metrics::Measures& row, const RunSize& run);

} // namespace corticle::record
