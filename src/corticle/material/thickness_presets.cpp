// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/thickness_presets.hpp"

#include <array>

namespace corticle::material
{

namespace
{

// The one place of these numbers: the schema and its page are printed from here.
constexpr std::array presets{
    PresetThickness{ThicknessPreset::linear_2_5, "linear_2.5mm", 2.5, 0.3, "Wang et al. 2019, thesis eq. 14"},
};

} // namespace

std::span<const PresetThickness> thickness_presets()
{
    return presets;
}

void apply_thickness_preset(TissueOptions& tissue)
{
    for (const PresetThickness& row : presets)
    {
        if (row.preset == tissue.thickness_preset)
        {
            tissue.thickness_mm = row.initial_mm;
            tissue.thickness_rate_mm = row.rate_mm;
        }
    }
}

} // namespace corticle::material
