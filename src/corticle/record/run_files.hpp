// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/checkpointing.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_request.hpp"
#include "corticle/record/summary.hpp"

#include <optional>

namespace corticle::record
{

/// Where the plot of the measures lies in a run folder.
inline constexpr const char* measures_picture = "pictures/measures.png";

/// Names of the pictures of a frame, relative to the run folder.
std::string surface_picture(std::string_view kind, const std::string& name);
std::string cut_picture(const std::string& name);
std::vector<std::string> frame_pictures(const std::string& name);

/// The files of a run besides those of its output times and the plot of its measures.
std::vector<std::string> run_files();

/// The files of an output time of this name, surface and particles, besides its pictures.
std::vector<std::string> frame_files(const std::string& name);

/// Refuses a folder that holds a run which was not asked to be resumed or overwritten, and one that holds a file which
/// the program did not write and the run would replace. Writes nothing.
void require_usable_folder(const ResultFolder& folder, const RunRequest& request);

/// The checkpoint to resume from, if the request and the folder have one.
/// @throws InputError when its case differs (naming the keys), it lies beyond the end of the case, or the file is
/// damaged
std::optional<Checkpoint> find_checkpoint(const RunRequest& request, const std::string& case_text);

/// Output times of a run: the start, those asked for, and the end; ascending.
std::vector<double> output_times(const config::Options& options);

/// Which of the output times get pictures.
std::vector<bool> picture_flags(const config::Options& options, std::span<const double> times);

/// surface.pvd, particles.pvd and measures.csv of the rows so far.
void write_tables(const std::filesystem::path& folder, std::span<const metrics::Measures> rows);

/// "0007"
std::string frame_name(std::size_t row);

} // namespace corticle::record
