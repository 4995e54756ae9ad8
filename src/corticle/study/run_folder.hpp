// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/communicator.hpp"
#include "corticle/model/observer.hpp"
#include "corticle/record/run_request.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace corticle::study
{

/// The program that a run is part of.
struct RunHost
{
    std::function<bool()> stop = [] { return false; }; ///< asked after every step; true interrupts the run
    std::function<void()> opened = [] {};              ///< called when the run folder is about to be written
    std::function<void(const std::string&)> warn = {}; ///< hears of warnings, one line each; run.log has them too
    std::vector<model::Observer*> observers = {};      ///< called after those that write the run folder
    bool draws = true;                                 ///< whether pictures may be drawn, which needs a display
    const Communicator* ranks = &alone();              ///< that share the work; rank 0 reads and writes
};

/// Runs a case into its run folder: frames, measures, pictures, checkpoints, summary.
/// @throws InputError before anything is written; RunError after, with the diagnosis; the last good checkpoint is kept.
/// Of several ranks all call it; what rank 0 throws, or finds while all look at the same, is thrown on all
model::RunStatus simulate(const record::RunRequest& request, const RunHost& host);

/// The same as a command: warnings go to stderr, and signals that ask the process to end interrupt the run.
model::RunStatus simulate(const record::RunRequest& request, const Communicator& ranks = alone());

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
