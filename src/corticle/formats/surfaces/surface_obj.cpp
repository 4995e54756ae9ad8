// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
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

/// Statements that do not change the surface: normals, texture, names, groups, materials, points and lines.
constexpr std::array<std::string_view, 14> ignored{"vn",     "vt",     "vp", "g", "o",      "s",   "mg",
                                                   "usemtl", "mtllib", "l",  "p", "usemap", "lod", "end"};

struct Line
{
    std::int64_t number = 0;
    std::string_view rest;
};

Vec3 vertex_of(Line line, const SurfaceBuilder& surface)
{
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
        const std::string_view word = take_word(line.rest);
        if (!to_number(word, position[axis]))
        {
            fail_reading(surface.file(), fmt::format("line {}: bad coordinate", line.number),
                         word.empty() ? "the end of the line" : word, "three numbers");
        }
    }
    return position;
}

/// OBJ counts from 1; a negative index counts back from the last vertex.
void corners_of(Line line, const SurfaceBuilder& surface, std::vector<std::int64_t>& corners)
{
    corners.clear();
    for (std::string_view word = take_word(line.rest); !word.empty() && word.front() != '#';
         word = take_word(line.rest))
    {
        std::int32_t index = 0;
        if (!to_number(word.substr(0, word.find('/')), index) || index == 0)
        {
            fail_reading(surface.file(), fmt::format("line {}: bad vertex index", line.number), word,
                         "whole numbers other than 0");
        }
        corners.push_back(index > 0 ? std::int64_t{index} - 1 : surface.vertex_count() + index);
    }
}

} // namespace

void parse_obj(std::string_view bytes, SurfaceBuilder& surface)
{
    std::vector<std::int64_t> corners;
    Line line;
    while (take_line(bytes, line.rest))
    {
        ++line.number;
        const std::string_view keyword = take_word(line.rest);
        if (keyword == "v")
        {
            surface.add_vertex(vertex_of(line, surface));
        }
        else if (keyword == "f")
        {
            corners_of(line, surface, corners);
            surface.add_polygon(corners);
        }
        else if (!keyword.empty() && keyword.front() != '#' && std::ranges::find(ignored, keyword) == ignored.end())
        {
            fail_reading(surface.file(), fmt::format("line {}: not an OBJ statement", line.number), keyword,
                         "v, f or another statement of polygonal OBJ");
        }
    }
}

} // namespace corticle::formats
