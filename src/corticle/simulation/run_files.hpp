// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/simulation/checkpointing.hpp"
#include "corticle/simulation/run_folder.hpp"
#include "corticle/simulation/summary.hpp"

#include <optional>

namespace corticle
{

/// Refuses an output folder that cannot be written or made. Writes nothing.
void require_writable_folder(const std::filesystem::path& out);

/// Refuses a run folder that cannot be written or that holds a run which was not asked to be resumed or overwritten.
/// Writes nothing.
void require_usable_folder(const RunRequest& request);

/// The checkpoint to resume from, if the request and the folder have one.
/// @throws InputError when its case differs (naming the keys) or the file is damaged
std::optional<Checkpoint> find_checkpoint(const RunRequest& request, const std::string& case_text);

/// Removes the files of an earlier run, and nothing else.
void remove_run(const std::filesystem::path& folder);

/// Removes what a killed process left half-written beside the files of a run.
void remove_leftovers(const std::filesystem::path& folder);

/// Output times of a run: the start, those asked for, and the end; ascending.
std::vector<double> output_times(const Options& options);

/// Which of the output times get pictures.
std::vector<bool> picture_flags(const Options& options, std::span<const double> times);

/// surface.pvd, particles.pvd and measures.csv of the rows so far.
void write_tables(const std::filesystem::path& folder, std::span<const Measures> rows);

/// "0007"
std::string frame_name(std::size_t row);

/// Makes a folder unless it is there. @throws InputError
void create_folder(const std::filesystem::path& folder);

} // namespace corticle
