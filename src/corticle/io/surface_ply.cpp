// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/format_error.hpp"
#include "corticle/io/surface_formats.hpp"
#include "corticle/io/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace corticle
{

namespace
{

enum class Type
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64,
    unknown
};

Type type_of(std::string_view name)
{
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        if (name == names[i][0] || name == names[i][1])
        {
            return static_cast<Type>(i);
        }
    }
    return Type::unknown;
}

constexpr std::array<std::size_t, 8> type_size{1, 1, 2, 2, 4, 4, 4, 8};

struct Property
{
    std::string_view name;
    Type type = Type::unknown;
    Type count_type = Type::unknown; ///< set for a list
    bool is_list = false;
};

struct Element
{
    std::string_view name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

enum class Format
{
    none,
    ascii,
    little_endian,
    big_endian
};

struct Header
{
    Format format = Format::none;
    std::vector<Element> elements;
};

double load_as_double(const char* at, Type type, bool big)
{
    switch (type)
    {
    case Type::int8:
        return load<std::int8_t>(at, big);
    case Type::uint8:
        return load<std::uint8_t>(at, big);
    case Type::int16:
        return load<std::int16_t>(at, big);
    case Type::uint16:
        return load<std::uint16_t>(at, big);
    case Type::int32:
        return load<std::int32_t>(at, big);
    case Type::uint32:
        return load<std::uint32_t>(at, big);
    case Type::float32:
        return load<float>(at, big);
    default:
        return load<double>(at, big);
    }
}

/// The numbers after the header, one by one. Each takes at least a byte, so a loop over them ends with the file.
class Numbers
{
  public:
    Numbers(std::string_view bytes, Format format, const SurfaceBuilder& surface)
        : bytes_(bytes), format_(format), surface_(surface)
    {
    }

    double take(Type type)
    {
        double value = 0.0;
        if (format_ == Format::ascii)
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
        value = load_as_double(bytes_.data(), type, format_ == Format::big_endian);
        bytes_.remove_prefix(size);
        return value;
    }

    std::int64_t take_whole(Type type)
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
    Format format_;
    const SurfaceBuilder& surface_;
};

Format format_of(std::string_view name, const SurfaceBuilder& surface)
{
    if (name == "ascii")
    {
        return Format::ascii;
    }
    if (name == "binary_little_endian")
    {
        return Format::little_endian;
    }
    if (name == "binary_big_endian")
    {
        return Format::big_endian;
    }
    fail_reading(surface.file(), "unknown PLY format", name, "ascii, binary_little_endian or binary_big_endian");
}

Property property_of(std::string_view line, const SurfaceBuilder& surface)
{
    const std::string_view whole = line;
    Property property;
    std::string_view word = take_word(line);
    property.is_list = word == "list";
    if (property.is_list)
    {
        property.count_type = type_of(take_word(line));
        word = take_word(line);
    }
    property.type = type_of(word);
    property.name = take_word(line);
    const bool bad_count =
        property.is_list && (property.count_type == Type::unknown || property.count_type >= Type::float32);
    if (property.type == Type::unknown || property.name.empty() || bad_count)
    {
        fail_reading(surface.file(), "bad PLY property", whole, "[list TYPE] TYPE NAME");
    }
    return property;
}

Element element_of(std::string_view line, const SurfaceBuilder& surface)
{
    Element element;
    element.name = take_word(line);
    const std::string_view count = take_word(line);
    if (!to_number(count, element.count) || element.count < 0)
    {
        fail_reading(surface.file(), "bad PLY element count", count, "a whole number");
    }
    return element;
}

/// Reads up to and with end_header; `text` then begins with the data.
Header take_header(std::string_view& text, const SurfaceBuilder& surface)
{
    Header header;
    std::string_view line;
    if (!take_line(text, line) || take_word(line) != "ply")
    {
        fail_reading(surface.file(), "not a PLY file", line, "ply on the first line");
    }
    while (take_line(text, line))
    {
        const std::string_view keyword = take_word(line);
        if (keyword == "end_header")
        {
            if (header.format == Format::none)
            {
                fail_reading(surface.file(), "PLY header without format", "none", "a format line");
            }
            return header;
        }
        if (keyword == "format")
        {
            header.format = format_of(take_word(line), surface);
        }
        else if (keyword == "element")
        {
            header.elements.push_back(element_of(line, surface));
        }
        else if (keyword == "property" && !header.elements.empty())
        {
            header.elements.back().properties.push_back(property_of(line, surface));
        }
        else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
        {
            fail_reading(surface.file(), "bad line in the PLY header", keyword,
                         "format, element, property, comment or end_header");
        }
    }
    fail_reading(surface.file(), "truncated PLY header", "the end of the file", "end_header");
}

/// Reads one record; `values` receives the plain numbers, `corners` the list of vertex indices.
void take_record(const Element& element, Numbers& numbers, std::vector<double>& values,
                 std::vector<std::int64_t>& corners)
{
    corners.clear();
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
        const Property& property = element.properties[p];
        if (!property.is_list)
        {
            values[p] = numbers.take(property.type);
            continue;
        }
        const std::int64_t count = numbers.take_whole(property.count_type);
        const bool is_polygon =
            element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
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

std::array<std::size_t, 3> coordinate_columns(const Element& element, const SurfaceBuilder& surface)
{
    std::array<std::size_t, 3> columns{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::string_view name = std::string_view("xyz").substr(axis, 1);
        const auto found =
            std::ranges::find_if(element.properties, [&](const Property& p) { return p.name == name && !p.is_list; });
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
    const Header header = take_header(text, surface);
    Numbers numbers(text, header.format, surface);
    std::vector<double> values;
    std::vector<std::int64_t> corners;
    for (const Element& element : header.elements)
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
        }
    }
}

} // namespace corticle
