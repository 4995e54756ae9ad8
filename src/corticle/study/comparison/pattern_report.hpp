// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/fold_pattern.hpp"

#include <nlohmann/json.hpp>

namespace corticle::study
{

/// A fold pattern beside that of a real surface, and the output time of the run that it is of.
struct PlacedPattern
{
    metrics::FoldPattern pattern;
    double place = 0.0; ///< of the run's output nearest to the real surface
};

/// Where folds lie, as a section of a report. @param axis  "week" | "t"
std::string pattern_section(const PlacedPattern& placed, const std::string& axis);

nlohmann::ordered_json pattern_json(const PlacedPattern& placed, const std::string& axis);

/// For the terminal: the run and the best of its controls.
std::string pattern_lines(const PlacedPattern& placed);

} // namespace corticle::study
