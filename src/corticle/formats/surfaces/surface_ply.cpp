// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/ply_header.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace corticle::formats
{

namespace
{

constexpr std::array<std::size_t, 8> type_size{1, 1, 2, 2, 4, 4, 4, 8};

double load_as_double(const char* at, PlyType type, bool big)
{
    switch (type)
    {
    case PlyType::int8:
        return load<std::int8_t>(at, big);
    case PlyType::uint8:
        return load<std::uint8_t>(at, big);
    case PlyType::int16:
        return load<std::int16_t>(at, big);
    case PlyType::uint16:
        return load<std::uint16_t>(at, big);
    case PlyType::int32:
        return load<std::int32_t>(at, big);
    case PlyType::uint32:
        return load<std::uint32_t>(at, big);
    case PlyType::float32:
        return load<float>(at, big);
    default:
        return load<double>(at, big);
    }
}

/// The numbers after the header, one by one. Each takes at least a byte, so a loop over them ends with the file.
class Numbers
{
  public:
    Numbers(std::string_view bytes, PlyFormat format, const SurfaceBuilder& surface)
        : bytes_(bytes), format_(format), surface_(surface)
    {
    }

    double take(PlyType type)
    {
        double value = 0.0;
        if (format_ == PlyFormat::ascii)
        {
            const std::string_view word = take_word(bytes_);
            if (!to_number(word, value))
            {
                fail("bad number in PLY", word.empty() ? "the end of the file" : word, "a number");
            }
            return value;
        }
        const std::size_t size = type_size[static_cast<std::size_t>(type)];
        if (bytes_.size() < size)
        {
            fail("truncated PLY", "the end of the file", "as many numbers as its header announces");
        }
        value = load_as_double(bytes_.data(), type, format_ == PlyFormat::big_endian);
        bytes_.remove_prefix(size);
        return value;
    }

    std::int64_t take_whole(PlyType type)
    {
        const double value = take(type);
        const bool is_whole = value >= -2147483648.0 && value <= 4294967295.0;
        if (!is_whole || static_cast<double>(static_cast<std::int64_t>(value)) != value)
        {
            fail("bad count or index in PLY", fmt::format("{}", value), "a whole number");
        }
        return static_cast<std::int64_t>(value);
    }

  private:
    [[noreturn]] void fail(std::string_view what, std::string_view got, std::string_view expected) const
    {
        fail_reading(surface_.file(),
                     fmt::format("{} after {} vertices and {} triangles", what, surface_.vertex_count(),
                                 surface_.triangle_count()),
                     got, expected);
    }

    std::string_view bytes_;
    PlyFormat format_;
    const SurfaceBuilder& surface_;
};

/// Reads one record; `values` receives the plain numbers, `corners` the list of vertex indices.
void take_record(const PlyElement& element, Numbers& numbers, std::vector<double>& values,
                 std::vector<std::int64_t>& corners)
{
    corners.clear();
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
        const PlyProperty& property = element.properties[p];
        if (!property.is_list)
        {
            values[p] = numbers.take(property.type);
            continue;
        }
        const std::int64_t count = numbers.take_whole(property.count_type);
        const bool is_polygon = (element.name == "face" || element.name == "tristrips") &&
                                (property.name == "vertex_indices" || property.name == "vertex_index");
        for (std::int64_t i = 0; i < count; ++i)
        {
            if (is_polygon)
            {
                corners.push_back(numbers.take_whole(property.type));
            }
            else
            {
                numbers.take(property.type);
            }
        }
    }
}

/// Strips of triangles, each ended by -1.
void add_strips(std::span<const std::int64_t> vertices, SurfaceBuilder& surface)
{
    while (!vertices.empty())
    {
        const auto end = std::ranges::find_if(vertices, [](std::int64_t vertex) { return vertex < 0; });
        const auto length = static_cast<std::size_t>(end - vertices.begin());
        surface.add_strip(vertices.first(length));
        vertices = vertices.subspan(std::min(length + 1, vertices.size()));
    }
}

std::array<std::size_t, 3> coordinate_columns(const PlyElement& element, const SurfaceBuilder& surface)
{
    std::array<std::size_t, 3> columns{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::string_view name = std::string_view("xyz").substr(axis, 1);
        const auto found = std::ranges::find_if(element.properties,
                                                [&](const PlyProperty& p) { return p.name == name && !p.is_list; });
        if (found == element.properties.end())
        {
            fail_reading(surface.file(), "PLY vertices without a coordinate", fmt::format("no {}", name), "x, y and z");
        }
        columns[axis] = static_cast<std::size_t>(found - element.properties.begin());
    }
    return columns;
}

} // namespace

void parse_ply(std::string_view text, SurfaceBuilder& surface)
{
    const PlyHeader header = take_ply_header(text, surface);
    Numbers numbers(text, header.format, surface);
    std::vector<double> values;
    std::vector<std::int64_t> corners;
    for (const PlyElement& element : header.elements)
    {
        const bool is_vertex = element.name == "vertex";
        const std::array<std::size_t, 3> columns =
            is_vertex ? coordinate_columns(element, surface) : std::array<std::size_t, 3>{};
        values.assign(element.properties.size(), 0.0);
        const std::int64_t records = element.properties.empty() ? 0 : element.count;
        for (std::int64_t record = 0; record < records; ++record)
        {
            take_record(element, numbers, values, corners);
            if (is_vertex)
            {
                surface.add_vertex({values[columns[0]], values[columns[1]], values[columns[2]]});
            }
            else if (element.name == "face")
            {
                surface.add_polygon(corners);
            }
            else if (element.name == "tristrips")
            {
                add_strips(corners, surface);
            }
        }
    }
}

} // namespace corticle::formats
