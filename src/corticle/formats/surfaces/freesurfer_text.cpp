// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/number_source.hpp"
#include "corticle/formats/surfaces/freesurfer_labels.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <array>

// FreeSurfer's text files, as mris_convert writes them (.asc), and lists of vertices (.label).

namespace corticle::formats
{

namespace
{

NumberSource numbers_of(std::string_view text, const std::string& name)
{
    return {text, 0, text.size(), NumberSource::Form::text, name};
}

} // namespace

void parse_freesurfer_text(std::string_view text, SurfaceBuilder& surface)
{
    NumberSource source = numbers_of(text, surface.file());
    source.skip_line(); // #!ascii version of ...
    const std::int64_t vertices = source.count(8, 0, 4, "number of vertices");
    const std::int64_t triangles = source.count(8, 0, 4, "number of triangles");
    surface.reserve(static_cast<std::size_t>(vertices), static_cast<std::size_t>(triangles));
    for (std::int64_t v = 0; v < vertices; ++v)
    {
        Vec3 position;
        for (int axis = 0; axis < 3; ++axis)
        {
            position[axis] = source.real("coordinate of a vertex");
        }
        source.real("mark of a vertex");
        surface.add_vertex(position);
    }
    for (std::int64_t t = 0; t < triangles; ++t)
    {
        std::array<std::int64_t, 3> corners{};
        for (std::int64_t& corner : corners)
        {
            corner = source.integer(8, "corner of a triangle");
        }
        source.real("mark of a triangle");
        surface.add_polygon(corners);
    }
    if (!source.is_at_end())
    {
        source.fail("text behind a FreeSurfer surface", source.word(), "the end of the file");
    }
    surface.note("a FreeSurfer text surface does not say where its volume lies: points are taken as they are");
}

std::vector<double> parse_freesurfer_text_scalars(std::string_view text, const std::string& name)
{
    NumberSource source = numbers_of(text, name);
    std::vector<double> values;
    while (!source.is_at_end())
    {
        const std::int64_t vertex = source.integer(8, "number of a vertex");
        if (vertex != std::ssize(values))
        {
            source.fail("values are not in the order of the vertices", fmt::format("vertex {}", vertex),
                        fmt::format("vertex {}", values.size()));
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            source.real("coordinate of a vertex");
        }
        values.push_back(source.real("value"));
    }
    return values;
}

std::vector<double> parse_freesurfer_label(std::string_view text, const std::string& name, std::int64_t vertex_count)
{
    NumberSource source = numbers_of(text, name);
    if (text.starts_with('#'))
    {
        source.skip_line();
    }
    const std::int64_t count = source.count(8, 0, 5, "number of vertices");
    std::vector<double> values(static_cast<std::size_t>(vertex_count), 0.0);
    for (std::int64_t k = 0; k < count; ++k)
    {
        const std::int64_t vertex = source.integer(8, "number of a vertex");
        if (vertex < 0 || vertex >= vertex_count)
        {
            source.fail("a label of another surface", fmt::format("vertex {}", vertex),
                        fmt::format("0 to {}", vertex_count - 1));
        }
        for (int skipped = 0; skipped < 4; ++skipped) // its place and a statistic
        {
            source.real("number of a vertex");
        }
        values[static_cast<std::size_t>(vertex)] = 1.0;
    }
    if (!source.is_at_end())
    {
        source.fail("text behind a FreeSurfer label", source.word(), "the end of the file");
    }
    return values;
}

} // namespace corticle::formats
