// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace corticle
{

struct CloudOptions
{
    double spacing = 0.0; ///< [mm]
    std::uint64_t seed = 1;
};

} // namespace corticle
