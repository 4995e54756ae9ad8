// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/parameters.hpp"

#include <vector>

namespace corticle::config
{

/// Keys of [boundary]: skull and fluid.
std::vector<Parameter> boundary_parameters();

/// Keys of [tracts].
std::vector<Parameter> tract_parameters();

/// Keys of [[support]]: those of the second are support.2.kind and so on.
std::vector<Parameter> support_parameters();

} // namespace corticle::config
