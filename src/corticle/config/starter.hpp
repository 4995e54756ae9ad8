// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace corticle
{

/// A commented case to start from; `shape` as in geometry.shape.
std::string starter_case(const std::string& shape);

} // namespace corticle
