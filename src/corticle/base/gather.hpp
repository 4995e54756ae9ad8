// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

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

/// The coordinates of points, one after another.
inline std::vector<double> flattened(std::span<const Vec3> points)
{
    std::vector<double> numbers;
    numbers.reserve(3 * points.size());
    for (const Vec3& point : points)
    {
        numbers.insert(numbers.end(), {point.x, point.y, point.z});
    }
    return numbers;
}

} // namespace corticle
