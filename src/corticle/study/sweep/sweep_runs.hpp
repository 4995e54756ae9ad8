// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/study/sweep/sweep_file.hpp"

#include <array>
#include <span>

namespace corticle::sweep
{

/// One run of a sweep.
struct SweepRun
{
    std::string name;            ///< of its axis places: "cfl-0.4_particles-8000"
    std::vector<std::size_t> at; ///< place on each axis
    config::Options options;
    std::string case_text; ///< resolved, see to_toml
};

/// Adds settings ("section.key=value"), in place of those of the same key.
/// @throws InputError for the key of an axis
void change_settings(SweepFile& sweep, std::span<const std::string> overrides);

/// All runs, the last axis fastest.
/// @throws InputError when the base cannot be read, or a case is not valid (naming the run)
std::vector<SweepRun> sweep_runs(const SweepFile& sweep);

/// What makes two runs give the same numbers: the resolved case, files by their content, without the keys that only
/// decide about pictures and checkpoints.
std::string case_identity(config::Options options);

/// A name for the folder of a run that says what makes it: the first 16 digits of the checksum of its case_identity.
std::string run_key(const config::Options& options);

/// The runs that `only` names, each by its number (from 1), its name, or "section.key=value" for all runs with this
/// value; all where it is empty.
/// @throws InputError for one that names none
std::vector<bool> chosen_runs(const SweepFile& sweep, std::span<const SweepRun> runs,
                              std::span<const std::string> only);

/// For each run the number of its reference run, from 0; none where the sweep has none or leaves it to the results
/// (finest). @throws InputError when the sweep refers to a run that does not exist
std::vector<std::optional<std::size_t>> given_references(const SweepFile& sweep, std::span<const SweepRun> runs);

} // namespace corticle::sweep
