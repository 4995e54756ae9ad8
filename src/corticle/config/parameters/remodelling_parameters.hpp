// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/parameters.hpp"

#include <vector>

namespace corticle::config
{

/// Keys of [fibres], [relaxation] and [stress_growth].
std::vector<Parameter> remodelling_parameters();

/// Options in which every one of these keys says something: what defaults are shown of.
void use_remodelling(Options& options);

} // namespace corticle::config
