// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/morris.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace corticle::sensitivity
{

namespace
{

constexpr double normal_90 = 1.645;

ElementaryEffects statistics(const std::vector<double>& effects)
{
    ElementaryEffects result;
    result.count = effects.size();
    const auto count = static_cast<double>(effects.size());
    for (const double effect : effects)
    {
        result.mean += effect / count;
        result.mean_magnitude += std::abs(effect) / count;
    }
    double squares = 0.0;
    double magnitude_squares = 0.0;
    for (const double effect : effects)
    {
        squares += (effect - result.mean) * (effect - result.mean);
        magnitude_squares += (std::abs(effect) - result.mean_magnitude) * (std::abs(effect) - result.mean_magnitude);
    }
    if (effects.size() > 1)
    {
        result.deviation = std::sqrt(squares / (count - 1.0));
        result.error = normal_90 * std::sqrt(magnitude_squares / (count - 1.0) / count);
    }
    return result;
}

} // namespace

std::vector<fit::Point> morris_paths(std::size_t count, std::size_t dimensions, std::size_t levels, std::uint64_t seed)
{
    assert(levels >= 2 && levels % 2 == 0);
    fit::Random random(seed);
    const auto intervals = static_cast<double>(levels - 1);
    const double step = static_cast<double>(levels) / (2.0 * intervals);
    std::vector<fit::Point> points;
    std::vector<std::size_t> order(dimensions);
    for (std::size_t path = 0; path < count; ++path)
    {
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t i = dimensions; i > 1; --i)
        {
            std::swap(order[i - 1], order[random.index(i)]);
        }
        fit::Point at(dimensions);
        for (double& coordinate : at)
        {
            coordinate = static_cast<double>(random.index(levels)) / intervals;
        }
        points.push_back(at);
        for (const std::size_t k : order)
        {
            // Exactly one of both directions stays within the cube.
            at[k] = at[k] + step > 1.0 + 1e-9 ? at[k] - step : at[k] + step;
            points.push_back(at);
        }
    }
    return points;
}

std::vector<ElementaryEffects> elementary_effects(std::span<const fit::Point> points, std::span<const double> values)
{
    assert(points.size() == values.size() && !points.empty());
    const std::size_t dimensions = points.front().size();
    std::vector<std::vector<double>> effects(dimensions);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        if (i % (dimensions + 1) == 0 || std::isnan(values[i]) || std::isnan(values[i - 1]))
        {
            continue;
        }
        for (std::size_t k = 0; k < dimensions; ++k)
        {
            if (const double change = points[i][k] - points[i - 1][k]; change != 0.0)
            {
                effects[k].push_back((values[i] - values[i - 1]) / change);
            }
        }
    }
    std::vector<ElementaryEffects> result;
    for (const std::vector<double>& one : effects)
    {
        result.push_back(statistics(one));
    }
    return result;
}

} // namespace corticle::sensitivity
