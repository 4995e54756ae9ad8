// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace corticle::config
{

/// Sets the times of supports where weeks do, and checks the keys of [[support]].
/// @param place  where a key was given, for messages
void settle_supports(Options& options, const std::function<std::string(std::string_view)>& place);

/// Sets the times of the skull's growth where weeks do, and checks the keys of [boundary].
void settle_boundary(Options& options, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
