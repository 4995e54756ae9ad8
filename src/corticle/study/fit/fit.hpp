// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/observer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::fit
{

/// What `corticle fit` was asked for.
struct FitRequest
{
    std::filesystem::path file;
    std::filesystem::path out;          ///< folder of the fit
    std::filesystem::path runs;         ///< folder of its runs; empty: OUT/runs
    std::vector<std::string> overrides; ///< "section.key=value" for all runs
    int jobs = 0;                       ///< runs side by side; 0: as many as there are cores
    int threads_per_run = 0;            ///< 0: so that the runs fill the cores
    bool quiet = false;
    std::string command = "/proc/self/exe";
};

/// Finds the parameters of a case whose runs come nearest to the targets, and how sure they are: search, design,
/// refinement, correction by dear runs, posterior (docs/guide/fitting.md). Writes best.toml, evaluations.csv, fit.json,
/// fit.md and plots/*.svg. Made again it finds the runs that were finished and goes the same way to the same bytes.
/// @throws InputError before anything is written; RunError when all runs fail
model::RunStatus fit(const FitRequest& request);

} // namespace corticle::fit
