// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/number_table.hpp"
#include "corticle/record/frames.hpp"

namespace corticle::record
{

/// Files of one output time of a run.
struct FrameFiles
{
    double t = 0.0;
    std::filesystem::path surface;
    std::filesystem::path particles;

    /// "0007", of surface_0007.vtp
    std::string name() const;
};

/// A run folder, as far as it is read at once.
struct RunContents
{
    std::filesystem::path folder;
    formats::NumberTable measures;  ///< measures.csv, whatever its columns; t ascends
    std::vector<FrameFiles> frames; ///< at least one; t ascends
};

/// True for a folder in which a run was begun.
bool is_run_folder(const std::filesystem::path& folder);

/// The output times of a run folder, from surface.pvd and particles.pvd; t ascends.
/// @throws InputError when it is not a run folder, or has no output time
std::vector<FrameFiles> list_frames(const std::filesystem::path& folder);

/// Measures and output times of a run folder. @throws InputError as list_frames, and when measures.csv is damaged
RunContents read_run(const std::filesystem::path& folder);

/// The week at growth time t, from the measures of a run with a clock; NaN where they hold none.
double week_at(const formats::NumberTable& measures, double t);

/// A frame from its files; their names end in "_NAME.vtp" and "_NAME.vtu". @throws InputError
Frame read_frame(const FrameFiles& files);

} // namespace corticle::record
