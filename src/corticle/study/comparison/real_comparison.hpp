// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/surface_rows.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/comparison/comparison.hpp"
#include "corticle/study/comparison/pattern_report.hpp"

#include <optional>

namespace corticle::study
{

/// A real surface at its week, or at a growth time.
struct RealSurface
{
    std::string name;   ///< as given: FILE@WEEK or FILE@t=T
    double place = 0.0; ///< on the axis of the comparison
    TriangleMesh surface;
    std::vector<metrics::SurfaceRow> rows;
    std::optional<PlacedPattern> pattern; ///< of the run beside it; none where the run does not reach it
    std::vector<std::string> notes;       ///< of its file, one line each
    std::vector<std::string> warnings;    ///< the same
};

/// A run beside real surfaces, all measured alike.
struct RealComparison
{
    std::string run_name;
    std::filesystem::path run_folder;
    RealSurfaceOptions reading;                             ///< how the real surfaces were read
    std::string axis;                                       ///< "week" | "t"
    std::vector<double> places;                             ///< output times of the run on the axis; ascends
    std::vector<std::vector<metrics::SurfaceRow>> run_rows; ///< at these
    std::vector<RealSurface> reals;

    /// Measure number `row` of the run, interpolated linearly to a real surface's place; NaN where the run
    /// does not reach.
    double run_value(std::size_t row, const RealSurface& real) const;
    /// Of reading the real surfaces: "NAME: warning".
    std::vector<std::string> warnings() const;
};

/// Measures a run and real surfaces.
/// @throws InputError for a folder that is not a run, a surface that is not one, a place that is missing (FILE without
/// @WEEK) or that the run cannot know (a week for a run without a clock), and when the run reaches none of them
RealComparison compare_with_real(const ComparisonRequest& request);

/// Names of the pictures that draw_comparison draws.
std::vector<std::string> comparison_pictures(const RealComparison& comparison);

/// Draws measures.png. @throws RunError
void draw_comparison(const std::filesystem::path& folder, const RealComparison& comparison);

/// comparison.json: see docs/guide/compare.md for the keys.
std::string comparison_json(const RealComparison& comparison, const Pictures& pictures);

/// report.md
std::string comparison_report(const RealComparison& comparison, const Pictures& pictures);

/// Some lines for the terminal.
std::string comparison_summary(const RealComparison& comparison);

} // namespace corticle::study
