// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/parameters.hpp"

#include <vector>

// The parts of the table of parameters that say what tissue is and how it grows.

namespace corticle::config
{

std::vector<Parameter> tissue_parameters();
std::vector<Parameter> growth_parameters();

} // namespace corticle::config
