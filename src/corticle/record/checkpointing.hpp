// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measures.hpp"
#include "corticle/record/checkpoint.hpp"

namespace corticle::record
{

/// "0.1.0, 0.2.0": the versions of the program that have made a run, this one last.
/// @param earlier  those of its checkpoint; empty for a new run
std::string versions_after(const std::string& earlier);

/// State and measured rows as a checkpoint of the case.
/// @param versions  of the program that have made the run, see versions_after()
Checkpoint to_checkpoint(const model::State& state, std::span<const metrics::Measures> rows,
                         const std::string& case_text, const std::string& versions = versions_after(""));

/// The growth time at which a checkpoint was taken. @throws InputError as from_checkpoint
double reached_time(const Checkpoint& checkpoint, const std::string& file);

/// What to_checkpoint stored.
struct Restored
{
    model::State state;
    std::vector<metrics::Measures> rows;
};
/// @throws InputError naming `file` when the checkpoint lacks something or holds another number of particles
Restored from_checkpoint(const Checkpoint& checkpoint, std::size_t particles, const std::string& file);

} // namespace corticle::record
