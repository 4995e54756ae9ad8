// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/gifti_numbers.hpp"

#include "corticle/formats/text_scan.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace corticle::formats
{

namespace
{

/// A number of one of these types.
double number_of(std::string_view type, const char* at, bool big_endian)
{
    const auto whole = [&]<class Signed, class Unsigned>(Signed, Unsigned)
    {
        return type.find("UINT") == std::string_view::npos ? static_cast<double>(load<Signed>(at, big_endian))
                                                           : static_cast<double>(load<Unsigned>(at, big_endian));
    };
    if (type.ends_with("FLOAT32"))
    {
        return static_cast<double>(load<float>(at, big_endian));
    }
    switch (type.ends_with("FLOAT64") ? 0 : bytes_of_gifti(type))
    {
    case 0:
        return load<double>(at, big_endian);
    case 1:
        return whole(std::int8_t{}, std::uint8_t{});
    case 2:
        return whole(std::int16_t{}, std::uint16_t{});
    case 4:
        return whole(std::int32_t{}, std::uint32_t{});
    default:
        return whole(std::int64_t{}, std::uint64_t{});
    }
}

} // namespace

std::size_t bytes_of_gifti(std::string_view type)
{
    constexpr std::array<std::pair<std::string_view, std::size_t>, 10> sizes{{{"NIFTI_TYPE_FLOAT32", 4},
                                                                              {"NIFTI_TYPE_FLOAT64", 8},
                                                                              {"NIFTI_TYPE_INT8", 1},
                                                                              {"NIFTI_TYPE_INT16", 2},
                                                                              {"NIFTI_TYPE_INT32", 4},
                                                                              {"NIFTI_TYPE_INT64", 8},
                                                                              {"NIFTI_TYPE_UINT8", 1},
                                                                              {"NIFTI_TYPE_UINT16", 2},
                                                                              {"NIFTI_TYPE_UINT32", 4},
                                                                              {"NIFTI_TYPE_UINT64", 8}}};
    const auto found = std::ranges::find(sizes, type, &std::pair<std::string_view, std::size_t>::first);
    return found == sizes.end() ? 0 : found->second;
}

std::vector<double> gifti_numbers(std::string_view bytes, std::string_view type, bool big_endian)
{
    const std::size_t size = bytes_of_gifti(type);
    std::vector<double> values(bytes.size() / size);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        values[i] = number_of(type, bytes.data() + i * size, big_endian);
    }
    return values;
}

} // namespace corticle::formats
