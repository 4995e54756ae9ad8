// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/formats/number_table.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/metrics/measures.hpp"
#include "corticle/record/frames.hpp"
#include "corticle/view/pictures.hpp"

#include <filesystem>

namespace corticle::view
{

/// A colour range that shows the bulk of the values (at least one): robust_range.
ColorScale robust_scale(std::string label, std::span<const double> values, ColorMap map);

/// The scale of an array of surface files: its words and unit, its map, and robust_range of the values; 0 is in the
/// middle of maps that diverge.
ColorScale scalar_scale(std::string_view key, std::span<const double> values);

/// "week 31", or "t = 0.5" where the week is not known (NaN).
std::string time_text(double t, double week);

/// The cut through the middle of a frame, across y, that shows `scalar` of its particles. Refers to both.
CutInput middle_cut(const record::Frame& frame, std::span<const double> scalar);

/// Pictures of one frame: surface by J, growth, sulcal depth and mean curvature, cut through the middle across y
/// (coronal where x points to the right and y to the front). `folder` is the run folder.
void render_frame(const std::filesystem::path& folder, const record::Frame& frame);

/// The columns of measures.csv.
formats::NumberTable number_table(std::span<const metrics::Measures> rows);

/// Plot of the measures against the weeks, or against t: PNG, SVG or PDF (render_plot).
void render_measures(const std::filesystem::path& file, const formats::NumberTable& measures);

/// Remakes all pictures of a run folder from its files.
/// @throws InputError when it is not a run folder, a run still writes to it, or a file that the program did not write
/// would be replaced
void render_run(const std::filesystem::path& folder);

} // namespace corticle::view
