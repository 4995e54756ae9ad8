// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/run_reader.hpp"
#include "corticle/report/page.hpp"

namespace corticle::report
{

/// summary.json of a run; an empty object where there is none.
Json read_summary(const std::filesystem::path& folder);

/// The measures of a run: [{"key", "label", "unit", "sentence", "group", "values"}], in the order of the table.
Json measures_json(const formats::NumberTable& measures);

/// What a page tells of a run besides its body and measures: headline, case, warnings, timing, methods.
Json facts_json(const std::filesystem::path& folder, const Json& summary);

/// Scalars of surfaces in words: {"key": {"label", "unit", "sentence", "map"}}.
Json scalars_json();

/// The colour maps: {"name": [[r, g, b], ...]}, each from 0 to 255.
Json color_maps_json();

} // namespace corticle::report
