// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue.hpp"

#include <algorithm>

namespace corticle::material
{

namespace
{

/// The map at t, linear in t between its times.
double value_at(const GrowthMaps& maps, std::size_t i, double t)
{
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(maps.times, t) - maps.times.begin());
    if (after == 0 || after == maps.times.size())
    {
        return maps.values[after == 0 ? 0 : after - 1][i];
    }
    const double part = (t - maps.times[after - 1]) / (maps.times[after] - maps.times[after - 1]);
    return (1.0 - part) * maps.values[after - 1][i] + part * maps.values[after][i];
}

/// Integral of the map from one time to a later one.
double integral(const GrowthMaps& maps, std::size_t i, double from, double to)
{
    double sum = 0.0;
    double begin = from;
    const auto add_until = [&](double end)
    {
        sum += 0.5 * (value_at(maps, i, begin) + value_at(maps, i, end)) * (end - begin); // linear in between
        begin = end;
    };
    for (const double time : maps.times)
    {
        if (time > begin && time < to)
        {
            add_until(time);
        }
    }
    add_until(to);
    return sum;
}

} // namespace

GrowthMaps::Mean GrowthMaps::mean(std::size_t i, double t) const
{
    const double now = value_at(*this, i, t);
    if (t <= from)
    {
        return {now, 0.0};
    }
    const double value = integral(*this, i, from, t) / (t - from);
    return {value, (now - value) / (t - from)};
}

} // namespace corticle::material
