// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/metrics/measures.hpp"
#include "corticle/prepare/prepare.hpp"

namespace corticle::record
{

/// What a summary holds besides the last measures.
struct RunInfo
{
    std::string status;   ///< "completed" | "failed" | "interrupted"
    std::string reason;   ///< of a failure
    std::string versions; ///< see versions_after()
    int threads = 1;
    double wall_s = 0.0; ///< all sessions of the run together
    double session_wall_s = 0.0;
    std::int64_t session_steps = 0;
    double measures_s = 0.0; ///< of the session, in measuring at output times
    double output_s = 0.0;   ///< of the session, in files, pictures and checkpoints
};

/// The files that a case names, by key: {"geometry.file": {"file": ..., "sha256": ...}}; as JSON.
std::string inputs_json(const config::Options& options);

/// summary.json: see docs/guide/run-folder.md for the keys.
std::string summary_json(const model::Simulation& simulation, const prepare::PreparationReport& made,
                         const config::Options& options, const metrics::Measures& last, const RunInfo& info);

/// summary.json of a run that failed before its first state: only what is known then.
std::string summary_without_state_json(const RunInfo& info);

/// Its keys whose values are numbers, those included that only some runs have.
std::vector<std::string> summary_number_keys();

/// Peak resident memory of this process [MB].
double peak_memory_mb();

} // namespace corticle::record
