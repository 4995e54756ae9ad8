// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/number_source.hpp"
#include "corticle/formats/tets/tet_formats.hpp"

#include <array>

// Two text formats that share the extension .mesh: Netgen's neutral one and that of Medit (INRIA report 0253).

namespace corticle::formats
{

namespace
{

Vec3 take_position(NumberSource& source)
{
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
        position[axis] = source.real("coordinate of a node");
    }
    return position;
}

void skip_integers(NumberSource& source, std::int64_t count, std::string_view what)
{
    for (std::int64_t k = 0; k < count; ++k)
    {
        source.integer(8, what);
    }
}

std::array<std::int64_t, 4> take_corners(NumberSource& source)
{
    std::array<std::int64_t, 4> corners{};
    for (std::int64_t& corner : corners)
    {
        corner = source.integer(8, "node of a tet");
    }
    return corners;
}

/// Takes the rest of a text in quotes that begins with this word.
void skip_quoted(NumberSource& source, std::string_view word)
{
    bool is_closed = word.size() > 1 && word.ends_with('"');
    while (!is_closed)
    {
        word = source.word();
        is_closed = word.empty() || word.ends_with('"');
    }
}

/// Takes the next word of a Medit file, past comments and texts in quotes, which may hold any word.
std::string_view take_keyword(NumberSource& source)
{
    std::string_view word = source.word();
    while (word.starts_with('#') || word.starts_with('"'))
    {
        word.front() == '#' ? source.skip_line() : skip_quoted(source, word);
        word = source.word();
    }
    return word;
}

void parse_medit_vertices(NumberSource& source, TetBuilder& mesh)
{
    const std::int64_t count = source.count(8, 0, 4, "number of vertices");
    mesh.reserve_nodes(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i)
    {
        const Vec3 position = take_position(source);
        source.real("reference of a vertex"); // a whole number, but some write 1.0
        mesh.add_node(mesh.node_count() + 1, position);
    }
}

void parse_medit_tets(NumberSource& source, TetBuilder& mesh, std::int64_t further_nodes)
{
    const std::int64_t count = source.count(8, 0, static_cast<std::size_t>(5 + further_nodes), "number of tets");
    for (std::int64_t i = 0; i < count; ++i)
    {
        const std::array<std::int64_t, 4> corners = take_corners(source);
        skip_integers(source, further_nodes, "node of a tet");
        source.integer(8, "reference of a tet");
        if (further_nodes > 0)
        {
            mesh.add_tet(std::array<std::int64_t, 5>{corners[0], corners[1], corners[2], corners[3], 0});
        }
        else
        {
            mesh.add_tet(corners);
        }
    }
}

} // namespace

void parse_netgen(std::string_view text, TetBuilder& mesh)
{
    NumberSource source(text, 0, text.size(), NumberSource::Form::text, mesh.file());
    const std::int64_t nodes = source.count(8, 0, 3, "number of nodes");
    mesh.reserve_nodes(static_cast<std::size_t>(nodes));
    for (std::int64_t i = 1; i <= nodes; ++i)
    {
        mesh.add_node(i, take_position(source));
    }
    const std::int64_t tets = source.count(8, 0, 5, "number of tets");
    for (std::int64_t i = 0; i < tets; ++i)
    {
        source.integer(8, "domain of a tet");
        mesh.add_tet(take_corners(source));
    }
    if (source.is_at_end())
    {
        return; // some leave out the surface, which nobody needs here
    }
    const std::int64_t triangles = source.count(8, 0, 4, "number of surface triangles");
    skip_integers(source, 4 * triangles, "surface triangle");
}

void parse_medit(std::string_view text, TetBuilder& mesh)
{
    NumberSource source(text, 0, text.size(), NumberSource::Form::text, mesh.file());
    std::int64_t dimension = 3;
    bool has_end = false;
    for (std::string_view word = take_keyword(source); !word.empty() && !has_end; word = take_keyword(source))
    {
        has_end = word == "End";
        if (word == "Dimension")
        {
            dimension = source.integer(8, "Dimension");
        }
        else if (word == "Vertices" && dimension == 3)
        {
            parse_medit_vertices(source, mesh);
        }
        else if (word == "Tetrahedra")
        {
            parse_medit_tets(source, mesh, 0);
        }
        else if (word == "TetrahedraP2")
        {
            parse_medit_tets(source, mesh, 6);
        }
        else if (word == "Hexahedra" || word == "Prisms" || word == "Pyramids")
        {
            source.fail("elements that are no tets", word, "a body of tets only");
        }
        // Whatever else there is, edges, triangles, corners, consists of numbers: its words are passed over.
    }
    if (dimension != 3)
    {
        source.fail("bad Dimension", std::to_string(dimension), "3");
    }
    if (!has_end)
    {
        source.fail("truncated Medit file", "no End", "End after the last section");
    }
}

} // namespace corticle::formats
