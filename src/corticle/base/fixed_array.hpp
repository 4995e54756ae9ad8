// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"

namespace corticle
{

/// std::array as far as code for a device knows it.
template <class T, int count>
struct FixedArray
{
    T values[count];

    CORTICLE_INLINE constexpr T& operator[](int k) { return values[k]; }
    CORTICLE_INLINE constexpr const T& operator[](int k) const { return values[k]; }
};

} // namespace corticle
