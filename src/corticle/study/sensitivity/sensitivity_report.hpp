// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/evaluator.hpp"
#include "corticle/study/sensitivity/morris.hpp"
#include "corticle/study/sensitivity/sensitivity_file.hpp"
#include "corticle/study/sensitivity/sobol.hpp"

#include <optional>

namespace corticle::sensitivity
{

/// What was found of one measure.
struct MeasureSensitivity
{
    std::vector<ElementaryEffects> effects; ///< of each parameter; empty: not screened
    std::optional<EmulatedIndices> sobol;
};

struct Findings
{
    std::vector<fit::Evaluation> evaluations;
    std::vector<MeasureSensitivity> measures;
};

std::string sensitivity_json(const SensitivityFile& file, const Findings& findings);
std::string sensitivity_markdown(const SensitivityFile& file, const Findings& findings);

/// Name and text of each plot.
std::vector<std::pair<std::string, std::string>> sensitivity_plots(const SensitivityFile& file,
                                                                   const Findings& findings);

} // namespace corticle::sensitivity
