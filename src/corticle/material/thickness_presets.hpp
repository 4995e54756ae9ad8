// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/options.hpp"

#include <span>
#include <string_view>

namespace corticle::material
{

/// A thickness H(t) = H_i + beta t that goes by a name.
struct PresetThickness
{
    ThicknessPreset preset;
    std::string_view name; ///< in a case
    double initial_mm;     ///< H_i, at t = 0
    double rate_mm;        ///< beta
    std::string_view source;
};

/// All of them but "none", in the order of the enumerators.
std::span<const PresetThickness> thickness_presets();

/// Gives thickness_mm and thickness_rate_mm the numbers of the preset; "none" leaves them.
void apply_thickness_preset(TissueOptions& tissue);

} // namespace corticle::material
