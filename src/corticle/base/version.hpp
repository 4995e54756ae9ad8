// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace corticle
{

/// "0.1.0", or "0.1.0 (5831044e2c1f)" where the program was built from a Git checkout; "+changes" follows the commit
/// where the checkout held more than that.
std::string_view program_version();

} // namespace corticle
