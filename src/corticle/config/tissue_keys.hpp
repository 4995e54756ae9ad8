// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace corticle::config
{

/// Refuses labels of tissues and laws of growth that do not go together with the other keys.
/// @param place  where a key was given, as " (case.toml:4)"; empty where it was not
/// @throws InputError
void check_tissue_keys(const Options& options, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
