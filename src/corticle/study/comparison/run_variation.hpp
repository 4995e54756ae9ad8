// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/pattern_variation.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/comparison/comparison.hpp"

namespace corticle::study
{

/// A measure of all runs at one time.
struct MeasureSpread
{
    std::string key; ///< as in summary.json
    std::string unit;
    double mean;
    double sd; ///< standard deviation between the runs
    double lowest;
    double highest;
};

/// Several runs of one body, as of different seeds of the imperfection, at one time that all have.
struct RunVariation
{
    std::vector<record::RunContents> runs;
    double t = 0.0;
    double week = 0.0; ///< NaN without a clock
    std::vector<MeasureSpread> measures;
    std::vector<Vec3> surface; ///< of the first run, then [mm]
    std::vector<Triangle> triangles;
    metrics::PatternVariation pattern;
};

/// @param times  the growth time to look at; empty: the last output time that all runs have
/// @throws InputError when one is not a run folder, is damaged, or is of another body; for several times, and for a
/// time at which one has no output
RunVariation compare_many_runs(std::span<const std::filesystem::path> folders, std::span<const double> times);

std::vector<std::string> comparison_pictures(const RunVariation& variation);

/// Draws sulcal_share.png and depth_sd.png. @throws RunError
void draw_comparison(const std::filesystem::path& folder, const RunVariation& variation);

/// variation.vtp: the surface of the first run with the maps. @throws RunError
void write_variation(const std::filesystem::path& file, const RunVariation& variation);

std::string comparison_json(const RunVariation& variation, const Pictures& pictures);
std::string comparison_report(const RunVariation& variation, const Pictures& pictures);
std::string comparison_summary(const RunVariation& variation);

} // namespace corticle::study
