// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/packed.hpp"

#include "corticle/formats/encoding.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::report
{

namespace
{

constexpr std::uint16_t missing = 65535;
constexpr double largest = 65534.0;

/// Bytes by their place in the differences of successive numbers, all lowest bytes first.
template <class Unsigned>
std::string planes_of_differences(std::span<const Unsigned> numbers)
{
    std::string bytes(sizeof(Unsigned) * numbers.size(), '\0');
    Unsigned before = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        const auto difference = static_cast<Unsigned>(numbers[i] - before);
        before = numbers[i];
        for (std::size_t k = 0; k < sizeof(Unsigned); ++k)
        {
            bytes[k * numbers.size() + i] = static_cast<char>(difference >> (8 * k) & 0xffu);
        }
    }
    return bytes;
}

std::pair<double, double> finite_range(std::span<const double> values, std::size_t components, std::size_t c)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = c; i < values.size(); i += components)
    {
        if (std::isfinite(values[i]))
        {
            low = std::min(low, values[i]);
            high = std::max(high, values[i]);
        }
    }
    return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
}

} // namespace

Json pack_numbers(std::span<const double> values, std::size_t components, Blobs& blobs, int step)
{
    const std::size_t count = values.size() / components;
    std::vector<std::uint16_t> numbers(values.size());
    Json json{{"blob", 0}, {"count", count}, {"low", Json::array()}, {"high", Json::array()}};
    for (std::size_t c = 0; c < components; ++c)
    {
        const auto [low, high] = finite_range(values, components, c);
        const double per_unit = high > low ? largest / (high - low) : 0.0;
        for (std::size_t i = 0; i < count; ++i)
        {
            const double value = values[components * i + c];
            const double number = step * std::round((value - low) * per_unit / step);
            numbers[c * count + i] =
                std::isfinite(value) ? static_cast<std::uint16_t>(std::min(number, largest)) : missing;
        }
        json["low"].push_back(low);
        json["high"].push_back(high);
    }
    json["blob"] = blobs.add(
        formats::to_base64(formats::pack_zlib(planes_of_differences(std::span<const std::uint16_t>(numbers)))));
    return json;
}

Json pack_indices(std::span<const std::uint32_t> indices, Blobs& blobs)
{
    return {{"blob", blobs.add(formats::to_base64(formats::pack_zlib(planes_of_differences(indices))))},
            {"count", indices.size()}};
}

} // namespace corticle::report
