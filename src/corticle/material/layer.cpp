// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/layer.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace corticle::material
{

double volume_inside(std::span<const double> inside, std::span<const double> volume)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
        sum += volume[i] * std::clamp(0.5 + inside[i] / std::cbrt(volume[i]), 0.0, 1.0);
    }
    return sum;
}

std::vector<double> sharp_layer(std::span<const double> inside, std::span<const double> volume, double cortex_volume)
{
    double left = cortex_volume;
    std::vector<std::size_t> outermost(inside.size());
    std::iota(outermost.begin(), outermost.end(), std::size_t{0});
    std::sort(outermost.begin(), outermost.end(),
              [&](std::size_t a, std::size_t b) { return inside[a] != inside[b] ? inside[a] > inside[b] : a < b; });
    std::vector<double> theta(inside.size(), 0.0);
    for (const std::size_t i : outermost)
    {
        if (left <= 1e-9 * volume[i]) // what round-off leaves of nothing
        {
            break;
        }
        theta[i] = std::clamp(left / volume[i], 0.0, 1.0);
        left -= volume[i];
    }
    return theta;
}

} // namespace corticle::material
