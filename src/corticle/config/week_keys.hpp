// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <functional>
#include <string_view>

namespace corticle::config
{

/// Checks the keys that speak of weeks and, where there is a clock, sets time.start and time.end from them.
/// `place(key)` says where a key was given: " (case.toml:4)", or "".
/// @throws InputError for a week without a clock, a clock without weeks, and weeks beyond its range or in wrong order
void settle_weeks(Options& options, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
