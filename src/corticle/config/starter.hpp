// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/prepare/options.hpp"

#include <string>

namespace corticle::config
{

/// A commented case to start from; `shape` as in geometry.shape.
std::string starter_case(prepare::Shape shape);

} // namespace corticle::config
