// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/comparison.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/comparison/comparison.hpp"

#include <array>

namespace corticle::study
{

/// A measure of two runs at their common times.
struct MeasurePair
{
    std::string key; ///< as in summary.json
    std::string unit;
    std::array<std::vector<double>, 2> values;
    std::vector<double> percent; ///< telling_percent

    /// The difference at a time for a table: in percent or, of shares, as it is.
    std::string shown_difference(std::size_t time) const;
};

/// How far two runs differ at one output time.
struct FramePair
{
    std::array<record::FrameFiles, 2> files;
    metrics::FieldDifference J;
    metrics::SurfaceDistance surface; ///< [mm]
};

/// Two runs side by side.
struct RunComparison
{
    std::array<std::string, 2> names; ///< different
    std::array<record::RunContents, 2> runs;
    std::array<std::size_t, 2> particles{};
    std::vector<double> times; ///< output times of either within the time that both cover
    std::vector<MeasurePair> measures;
    std::vector<FramePair> frames;     ///< output times that both have
    std::vector<std::size_t> pictured; ///< of these, those to draw
};

/// The key of a measure as summary.json writes it, whether the table names the unit in it or not:
/// ("area", "mm2") and ("area_mm2", "mm2") are "area_mm2".
std::string measure_key(const formats::NumberColumn& column);

/// J = det F of the particles of a frame.
std::vector<double> volume_ratios(const record::Frame& frame);

/// Compares measures, J and surfaces of two run folders.
/// @param picture_times  growth times to draw; empty: half and end
/// @throws InputError when one is not a run folder, is damaged, or they have no time in common
RunComparison compare_runs(const std::array<std::filesystem::path, 2>& folders, std::span<const double> picture_times);

/// J of two runs at one output time that both have.
struct JComparison
{
    std::array<double, 2> t{}; ///< of the frames
    metrics::FieldDifference J;
};

/// Compares J of two run folders at their last common output time, of those not after `latest`.
/// @throws InputError when one is not a run folder, is damaged, or they have no such time
JComparison compare_last_J(const std::array<std::filesystem::path, 2>& folders, double latest);

/// Names of the pictures that draw_comparison draws.
std::vector<std::string> comparison_pictures(const RunComparison& comparison);

/// Draws measures.png and, for each pictured time, surface_J_*.png and cut_J_*.png. @throws RunError
void draw_comparison(const std::filesystem::path& folder, const RunComparison& comparison);

/// comparison.json: see docs/guide/compare.md for the keys.
std::string comparison_json(const RunComparison& comparison, const Pictures& pictures);

/// report.md
std::string comparison_report(const RunComparison& comparison, const Pictures& pictures);

/// Some lines for the terminal: the differences at the last common time.
std::string comparison_summary(const RunComparison& comparison);

} // namespace corticle::study
