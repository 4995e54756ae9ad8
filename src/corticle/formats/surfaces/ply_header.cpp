// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/ply_header.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <array>

namespace corticle::formats
{

namespace
{

PlyType type_of(std::string_view name)
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
            return static_cast<PlyType>(i);
        }
    }
    return PlyType::unknown;
}

PlyFormat format_of(std::string_view name, const SurfaceBuilder& surface)
{
    if (name == "ascii")
    {
        return PlyFormat::ascii;
    }
    if (name == "binary_little_endian")
    {
        return PlyFormat::little_endian;
    }
    if (name == "binary_big_endian")
    {
        return PlyFormat::big_endian;
    }
    fail_reading(surface.file(), "unknown PLY format", name, "ascii, binary_little_endian or binary_big_endian");
}

PlyProperty property_of(std::string_view line, const SurfaceBuilder& surface)
{
    const std::string_view whole = line;
    PlyProperty property;
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
        property.is_list && (property.count_type == PlyType::unknown || property.count_type >= PlyType::float32);
    if (property.type == PlyType::unknown || property.name.empty() || bad_count)
    {
        fail_reading(surface.file(), "bad PLY property", whole, "[list TYPE] TYPE NAME");
    }
    return property;
}

PlyElement element_of(std::string_view line, const SurfaceBuilder& surface)
{
    PlyElement element;
    element.name = take_word(line);
    const std::string_view count = take_word(line);
    if (!to_number(count, element.count) || element.count < 0)
    {
        fail_reading(surface.file(), "bad PLY element count", count, "a whole number");
    }
    return element;
}

} // namespace

PlyHeader take_ply_header(std::string_view& text, const SurfaceBuilder& surface)
{
    PlyHeader header;
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
            if (header.format == PlyFormat::none)
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

} // namespace corticle::formats
