// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <functional>
#include <string_view>

namespace corticle::config
{

/// With solver.formulation = "thesis" gives the keys that are not given (`place(key)` is empty) the thesis's values,
/// and refuses keys of [thesis] without it. @throws InputError
void settle_formulation(Options& options, const std::function<std::string(std::string_view)>& place);

} // namespace corticle::config
