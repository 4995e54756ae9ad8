// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace corticle::config
{

/// Refuses keys of [fibres], [relaxation] and [stress_growth] that do nothing in this case or cannot go with others.
/// @throws InputError
void check_remodelling(const Options& options, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
