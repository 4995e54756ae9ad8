// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Values at these places, in their order.
template <class T>
std::vector<T> gather(std::span<const T> values, std::span<const std::int32_t> places)
{
    std::vector<T> result;
    result.reserve(places.size());
    for (const std::int32_t k : places)
    {
        result.push_back(values[static_cast<std::size_t>(k)]);
    }
    return result;
}

} // namespace corticle
