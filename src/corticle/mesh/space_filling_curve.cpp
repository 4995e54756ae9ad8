// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/space_filling_curve.hpp"

#include "corticle/base/box.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace corticle
{

namespace
{

constexpr int bits = 16;

} // namespace

std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    std::array<std::uint32_t, 3> c{x, y, z};
    // From coordinates to the transposed key: undo the rotations and reflections, then Gray-encode.
    for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
    {
        const std::uint32_t mask = q - 1;
        for (std::uint32_t& value : c)
        {
            if ((value & q) != 0)
            {
                c[0] ^= mask;
            }
            else
            {
                const std::uint32_t swapped = (c[0] ^ value) & mask;
                c[0] ^= swapped;
                value ^= swapped;
            }
        }
    }
    c[1] ^= c[0];
    c[2] ^= c[1];
    std::uint32_t flip = 0;
    for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
    {
        flip ^= (c[2] & q) != 0 ? q - 1 : 0;
    }
    std::uint64_t key = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
    {
        for (const std::uint32_t value : c)
        {
            key = (key << 1) | (((value ^ flip) >> bit) & 1u);
        }
    }
    return key;
}

std::vector<std::int32_t> hilbert_order(std::span<const Vec3> points)
{
    if (points.empty())
    {
        return {};
    }
    const Box box = bounding_box(points);
    const double side = box.size()[box.longest_axis()];
    const double steps = side > 0.0 ? static_cast<double>((1u << bits) - 1) / side : 0.0;
    std::vector<std::pair<std::uint64_t, std::int32_t>> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Vec3 p = steps * (points[i] - box.low);
        keys[i] = {hilbert_key(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y),
                               static_cast<std::uint32_t>(p.z)),
                   static_cast<std::int32_t>(i)};
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::int32_t> order(points.size());
    std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& entry) { return entry.second; });
    return order;
}

} // namespace corticle
