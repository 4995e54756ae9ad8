// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/observer.hpp"
#include "corticle/record/run_request.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace corticle::study
{

/// Runs a case into its run folder: frames, measures, pictures, checkpoints, summary.
/// @throws InputError before anything is written; RunError after, with the diagnosis; the last good checkpoint is kept
model::RunStatus simulate(const record::RunRequest& request);

/// What a run would take, without running it.
struct Plan
{
    std::int64_t particles = 0;
    std::int64_t surface_vertices = 0;
    double spacing_mm = 0.0;
    double neighbors_mean = 0.0;
    double steps = 0.0;
    double memory_mb = 0.0;
    double seconds = 0.0;
    std::string text; ///< all of it, for people
};

/// Prepares the body and times a few force evaluations. @throws InputError
Plan plan(const config::Options& options, int threads);

} // namespace corticle::study
