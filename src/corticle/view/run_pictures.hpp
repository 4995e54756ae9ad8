// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/metrics/measures.hpp"
#include "corticle/record/frames.hpp"
#include "corticle/view/pictures.hpp"

#include <filesystem>

namespace corticle::view
{

/// A colour range that shows the bulk of the values (at least one): robust_range.
ColorScale robust_scale(std::string label, std::span<const double> values, ColorMap map);

/// The cut through the middle of a frame, across y, that shows `scalar` of its particles. Refers to both.
CutInput middle_cut(const record::Frame& frame, std::span<const double> scalar);

/// Pictures of one frame: surface by J, growth, sulcal depth and mean curvature, cut through the middle across y
/// (coronal where x points to the right and y to the front). `folder` is the run folder.
void render_frame(const std::filesystem::path& folder, const record::Frame& frame);

/// Plot of the measures against the weeks, or against t.
void render_measures(const std::filesystem::path& folder, std::span<const metrics::Measures> rows);

/// Remakes all pictures of a run folder from its files.
/// @throws InputError when it is not a run folder, a run still writes to it, or a file that the program did not write
/// would be replaced
void render_run(const std::filesystem::path& folder);

} // namespace corticle::view
