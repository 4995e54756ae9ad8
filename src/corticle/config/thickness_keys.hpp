// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/options.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace corticle::config
{

/// Puts the numbers of tissue.thickness_preset in place. `place(key)` says where a key was given: " (case.toml:4)", or
/// "".
/// @throws InputError where a preset stands beside a number of the thickness or beside tissue.lambda
void settle_thickness(material::TissueOptions& tissue, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
