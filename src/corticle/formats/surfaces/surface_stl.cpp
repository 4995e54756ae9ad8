// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::formats
{

namespace
{

constexpr std::size_t header_size = 84; // 80 free bytes and the number of triangles
constexpr std::size_t facet_size = 50;  // normal and three corners as float, two bytes of attributes

void add_triangle(const std::array<Vec3, 3>& corners, SurfaceBuilder& surface)
{
    const std::int64_t first = surface.vertex_count();
    for (const Vec3& corner : corners)
    {
        surface.add_vertex(corner);
    }
    surface.add_polygon(std::array{first, first + 1, first + 2});
}

void parse_binary(std::string_view bytes, std::size_t triangles, SurfaceBuilder& surface)
{
    surface.reserve(3 * triangles, triangles);
    for (std::size_t t = 0; t < triangles; ++t)
    {
        const char* facet = bytes.data() + header_size + t * facet_size + 12;
        std::array<Vec3, 3> corners;
        for (std::size_t c = 0; c < 3; ++c)
        {
            const char* corner = facet + 12 * c;
            corners[c] = {load<float>(corner, false), load<float>(corner + 4, false), load<float>(corner + 8, false)};
        }
        add_triangle(corners, surface);
    }
}

Vec3 take_position(std::string_view& text, const SurfaceBuilder& surface)
{
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
        const std::string_view word = take_word(text);
        if (!to_number(word, position[axis]))
        {
            fail_reading(surface.file(), fmt::format("facet {} has a bad coordinate", surface.triangle_count()),
                         word.empty() ? "the end of the file" : word, "a number");
        }
    }
    return position;
}

void expect_words(std::string_view& text, std::initializer_list<std::string_view> words, const SurfaceBuilder& surface)
{
    for (const std::string_view expected : words)
    {
        const std::string_view word = take_word(text);
        const bool is_parted = equals_ignoring_case(word, "end") && expected.starts_with("end"); // "end loop"
        if (is_parted ? !equals_ignoring_case(take_word(text), expected.substr(3))
                      : !equals_ignoring_case(word, expected))
        {
            fail_reading(surface.file(), fmt::format("facet {} is malformed", surface.triangle_count()),
                         word.empty() ? "the end of the file" : word, expected);
        }
    }
}

void parse_facet(std::string_view& text, SurfaceBuilder& surface)
{
    expect_words(text, {"normal"}, surface);
    for (int axis = 0; axis < 3; ++axis)
    {
        take_word(text); // the normal follows from the corners; some writers put nan there
    }
    expect_words(text, {"outer", "loop"}, surface);
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners)
    {
        expect_words(text, {"vertex"}, surface);
        corner = take_position(text, surface);
    }
    expect_words(text, {"endloop", "endfacet"}, surface);
    add_triangle(corners, surface);
}

void parse_ascii(std::string_view bytes, SurfaceBuilder& surface)
{
    std::string_view text = bytes;
    std::string_view ignored;
    bool inside = false;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
    {
        if (!inside && equals_ignoring_case(word, "solid"))
        {
            take_line(text, ignored); // its name
            inside = true;
        }
        else if (inside && equals_ignoring_case(word, "facet"))
        {
            parse_facet(text, surface);
        }
        else if (inside && (equals_ignoring_case(word, "endsolid") || equals_ignoring_case(word, "end")))
        {
            take_line(text, ignored); // "solid", perhaps, and its name
            inside = false;
        }
        else
        {
            fail_reading(surface.file(), fmt::format("not an ASCII STL after {} facets", surface.triangle_count()),
                         word, inside ? "facet or endsolid" : "solid");
        }
    }
    if (inside)
    {
        fail_reading(surface.file(), "truncated ASCII STL",
                     fmt::format("{} facets and no endsolid", surface.triangle_count()), "endsolid at the end");
    }
}

/// Text begins with the word "solid". Binary files may do so as well: their size distinguishes them, or bytes that text
/// does not hold.
bool is_text(std::string_view bytes)
{
    std::string_view rest = bytes;
    if (!equals_ignoring_case(take_word(rest).substr(0, 5), "solid"))
    {
        return false;
    }
    const bool has_size_of_binary =
        bytes.size() >= header_size &&
        bytes.size() == header_size + facet_size * load<std::uint32_t>(bytes.data() + header_size - 4, false);
    return !has_size_of_binary && bytes.find('\0') == std::string_view::npos;
}

} // namespace

void parse_stl(std::string_view bytes, SurfaceBuilder& surface)
{
    if (is_text(bytes))
    {
        return parse_ascii(bytes, surface);
    }
    if (bytes.size() < header_size)
    {
        fail_reading(surface.file(), "not an STL file", fmt::format("{} bytes", bytes.size()),
                     "text that begins with solid, or at least 84 bytes");
    }
    const std::size_t triangles = load<std::uint32_t>(bytes.data() + header_size - 4, false);
    const std::size_t needed = header_size + facet_size * triangles;
    if (bytes.size() < needed)
    {
        fail_reading(surface.file(), "truncated binary STL, or text that does not begin with solid",
                     fmt::format("{} bytes", bytes.size()),
                     fmt::format("{} for the {} triangles it announces", needed, triangles));
    }
    parse_binary(bytes, triangles, surface);
}

} // namespace corticle::formats
