// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/robust_range.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::view
{

namespace
{

constexpr double tail = 0.02;
constexpr double fence = 1.5;   // interquartile ranges beyond the quartiles (J. W. Tukey, 1977)
constexpr double narrow = 0.05; // an interquartile range below this share of the rest says nothing of the tails
constexpr double hardly = 1e-3; ///< of the size of the values
constexpr int steps = 10;

std::vector<double> finite_of(std::span<const double> values)
{
    std::vector<double> finite;
    finite.reserve(values.size());
    std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) { return std::isfinite(v); });
    return finite;
}

/// The value below which this share lies.
double quantile(std::vector<double>& values, double share)
{
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace

Range full_range(std::span<const double> values)
{
    const std::vector<double> finite = finite_of(values);
    if (finite.empty())
    {
        return {};
    }
    const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
    return {*low, *high};
}

Range robust_range(std::span<const double> values)
{
    std::vector<double> finite = finite_of(values);
    if (finite.empty())
    {
        return {};
    }
    double low = quantile(finite, tail);
    double high = quantile(finite, 1.0 - tail);
    const double quarter = quantile(finite, 0.25);
    const double three_quarters = quantile(finite, 0.75);
    if (const double middle_half = three_quarters - quarter; middle_half > narrow * (high - low))
    {
        low = std::max(low, quarter - fence * middle_half);
        high = std::min(high, three_quarters + fence * middle_half);
    }
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= hardly * size)
    {
        const double half = size > 0.0 ? round_step(size, steps) : 1.0;
        const double middle = std::round(0.5 * (low + high) / half) * half;
        return {middle - half, middle + half};
    }
    const double step = round_step(high - low, steps);
    return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step};
}

std::vector<double> round_ticks(double low, double high, int count)
{
    std::vector<double> ticks;
    if (!(high > low))
    {
        return {low};
    }
    const double step = round_step(high - low, count);
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
    {
        ticks.push_back(k * step);
    }
    return ticks;
}

double round_step(double length, int count)
{
    const double rough = length / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

} // namespace corticle::view
