// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/comparison/real_surface.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::study
{

/// What `corticle compare` was asked for.
struct ComparisonRequest
{
    std::filesystem::path run;
    std::vector<std::string> others; ///< run folders, or real surfaces, each FILE@WEEK or FILE@t=T
    std::filesystem::path out;       ///< empty: compare_<run>_<other>, of the paths as they are given
    bool overwrite = false;          ///< replace an earlier report in the folder
    /// Growth times of the pictures [-]; empty: half and end. Of more than two runs: the one to compare them at.
    std::vector<double> picture_times;
    RealSurfaceOptions real; ///< how real surfaces are read
    bool patterns = true; ///< whether to find how far the folds are at the right place, which takes seconds a surface
};

/// Pictures of a report.
struct Pictures
{
    std::vector<std::string> files; ///< relative to its folder
    std::string reason;             ///< why there are none
};

/// What a comparison gave.
struct ComparisonOutcome
{
    std::filesystem::path folder; ///< holds report.md, comparison.json and the pictures
    std::string json;             ///< comparison.json
    std::string summary;          ///< some lines for the terminal
    Pictures pictures;
    std::vector<std::string> warnings{}; ///< about real surfaces, one line each
    bool has_page = true;                ///< whether `corticle report` can show it
};

/// Compares a run with another run, with several of the same body, or with real surfaces: reads all, then writes
/// report.md, comparison.json and pictures into the folder, each whole or not at all. The same input gives the same
/// bytes.
/// @throws InputError before anything is written; RunError when it cannot be written
ComparisonOutcome compare(const ComparisonRequest& request);

} // namespace corticle::study
