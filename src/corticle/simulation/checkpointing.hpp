// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/io/checkpoint.hpp"
#include "corticle/simulation/measures.hpp"

namespace corticle
{

/// State and measured rows as a checkpoint of the case.
Checkpoint to_checkpoint(const State& state, std::span<const Measures> rows, const std::string& case_text);

/// The growth time at which a checkpoint was taken. @throws InputError as from_checkpoint
double reached_time(const Checkpoint& checkpoint, const std::string& file);

/// What to_checkpoint stored.
struct Restored
{
    State state;
    std::vector<Measures> rows;
};
/// @throws InputError naming `file` when the checkpoint lacks something or holds another number of particles
Restored from_checkpoint(const Checkpoint& checkpoint, std::size_t particles, const std::string& file);

} // namespace corticle
