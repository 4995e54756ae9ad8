// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/thickness_keys.hpp"

#include "corticle/base/error.hpp"
#include "corticle/material/thickness_presets.hpp"

#include <fmt/format.h>

namespace corticle::config
{

void settle_thickness(material::TissueOptions& tissue, const std::function<std::string(std::string_view)>& place)
{
    if (tissue.thickness_preset == material::ThicknessPreset::none)
    {
        return;
    }
    for (const std::string_view key : {"tissue.thickness_mm", "tissue.thickness_rate_mm", "tissue.lambda"})
    {
        const bool is_given = key == "tissue.lambda" ? tissue.lambda > 0.0 : !place(key).empty();
        if (is_given)
        {
            throw InputError(fmt::format("{}{} is given beside tissue.thickness_preset{}: expected one of them, or "
                                         "thickness_preset = \"none\"",
                                         key, place(key), place("tissue.thickness_preset")));
        }
    }
    material::apply_thickness_preset(tissue);
}

} // namespace corticle::config
