// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace corticle::formats
{

namespace
{

/// The next line that holds something once its comment is cut.
std::string_view take_content(std::string_view& text, const SurfaceBuilder& surface, std::string_view expected)
{
    std::string_view line;
    while (take_line(text, line))
    {
        line = line.substr(0, line.find('#'));
        if (std::any_of(line.begin(), line.end(), [](char c) { return !is_space(c); }))
        {
            return line;
        }
    }
    fail_reading(surface.file(), "truncated OFF", "the end of the file", expected);
}

template <class Number>
Number take_number(std::string_view& line, const SurfaceBuilder& surface, std::string_view what)
{
    const std::string_view word = take_word(line);
    Number value{};
    if (!to_number(word, value))
    {
        fail_reading(surface.file(), fmt::format("bad {} in OFF", what), word.empty() ? "the end of the line" : word,
                     "a number");
    }
    return value;
}

} // namespace

void parse_off(std::string_view text, SurfaceBuilder& surface)
{
    const std::size_t bytes = text.size();
    std::string_view line = take_content(text, surface, "OFF on the first line");
    const std::string_view magic = take_word(line);
    // Texture (ST), colours (C) and normals (N) stand behind the place; a fourth coordinate (4) or any number (n) not.
    const std::string_view prefix = magic.substr(0, magic.find("OFF"));
    if (!magic.ends_with("OFF") || prefix.find_first_not_of("STCN") != std::string_view::npos)
    {
        fail_reading(surface.file(), "not an OFF file of places in space", magic,
                     "OFF on the first line, perhaps with ST, C or N before it");
    }
    if (std::all_of(line.begin(), line.end(), is_space))
    {
        line = take_content(text, surface, "the numbers of vertices and faces");
    }
    const auto vertices = take_number<std::int64_t>(line, surface, "number of vertices");
    const auto faces = take_number<std::int64_t>(line, surface, "number of faces");
    // A vertex takes at least 6 bytes ("0 0 0" and the end of its line), a face 4.
    if (vertices < 0 || faces < 0 || vertices > static_cast<std::int64_t>(bytes / 6 + 1) ||
        faces > static_cast<std::int64_t>(bytes / 4 + 1))
    {
        fail_reading(surface.file(), "OFF announces more than the file holds",
                     fmt::format("{} vertices and {} faces", vertices, faces),
                     fmt::format("what {} bytes can hold", bytes));
    }
    surface.reserve(static_cast<std::size_t>(vertices), static_cast<std::size_t>(faces));
    for (std::int64_t v = 0; v < vertices; ++v)
    {
        line = take_content(text, surface, fmt::format("{} vertices", vertices));
        Vec3 position;
        for (int axis = 0; axis < 3; ++axis)
        {
            position[axis] = take_number<double>(line, surface, fmt::format("coordinate of vertex {}", v));
        }
        surface.add_vertex(position);
    }
    std::vector<std::int64_t> corners;
    for (std::int64_t f = 0; f < faces; ++f)
    {
        line = take_content(text, surface, fmt::format("{} faces", faces));
        const auto count = take_number<std::int64_t>(line, surface, fmt::format("number of corners of face {}", f));
        corners.clear();
        for (std::int64_t c = 0; c < count; ++c)
        {
            corners.push_back(take_number<std::int64_t>(line, surface, fmt::format("corner of face {}", f)));
        }
        surface.add_polygon(corners);
    }
}

} // namespace corticle::formats
