// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/tets/gmsh_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::formats
{

namespace
{

constexpr std::array element_types{
    GmshElementType{1, 2, GmshUse::flat, "line"},          GmshElementType{2, 3, GmshUse::flat, "triangle"},
    GmshElementType{3, 4, GmshUse::flat, "quadrangle"},    GmshElementType{4, 4, GmshUse::tet, "tet"},
    GmshElementType{5, 8, GmshUse::solid, "hexahedron"},   GmshElementType{6, 6, GmshUse::solid, "prism"},
    GmshElementType{7, 5, GmshUse::solid, "pyramid"},      GmshElementType{8, 3, GmshUse::flat, "line"},
    GmshElementType{9, 6, GmshUse::flat, "triangle"},      GmshElementType{10, 9, GmshUse::flat, "quadrangle"},
    GmshElementType{11, 10, GmshUse::tet, "tet"},          GmshElementType{12, 27, GmshUse::solid, "hexahedron"},
    GmshElementType{13, 18, GmshUse::solid, "prism"},      GmshElementType{14, 14, GmshUse::solid, "pyramid"},
    GmshElementType{15, 1, GmshUse::flat, "point"},        GmshElementType{16, 8, GmshUse::flat, "quadrangle"},
    GmshElementType{17, 20, GmshUse::solid, "hexahedron"}, GmshElementType{18, 15, GmshUse::solid, "prism"},
    GmshElementType{19, 13, GmshUse::solid, "pyramid"},    GmshElementType{20, 9, GmshUse::flat, "triangle"},
    GmshElementType{21, 10, GmshUse::flat, "triangle"},    GmshElementType{22, 12, GmshUse::flat, "triangle"},
    GmshElementType{23, 15, GmshUse::flat, "triangle"},    GmshElementType{24, 15, GmshUse::flat, "triangle"},
    GmshElementType{25, 21, GmshUse::flat, "triangle"},    GmshElementType{26, 4, GmshUse::flat, "line"},
    GmshElementType{27, 5, GmshUse::flat, "line"},         GmshElementType{28, 6, GmshUse::flat, "line"},
    GmshElementType{29, 20, GmshUse::tet, "tet"},          GmshElementType{30, 35, GmshUse::tet, "tet"},
    GmshElementType{31, 56, GmshUse::tet, "tet"},
};

constexpr std::size_t most_nodes = 56; ///< of an element

} // namespace

const GmshElementType& gmsh_element_type(std::int64_t number, const NumberSource& source)
{
    const auto found = std::find_if(element_types.begin(), element_types.end(),
                                    [&](const GmshElementType& type) { return type.number == number; });
    if (found == element_types.end())
    {
        source.fail("unknown type of element", fmt::format("type {}", number), "types 1 to 31");
    }
    if (found->use == GmshUse::solid)
    {
        source.fail("an element that is no tet", fmt::format("a {} (type {})", found->name, number),
                    "a body of tets only");
    }
    return *found;
}

void take_gmsh_element(NumberSource& source, const GmshElementType& type, int tag_bytes, TetBuilder& mesh)
{
    std::array<std::int64_t, most_nodes> nodes{};
    for (std::size_t k = 0; k < type.nodes; ++k)
    {
        nodes[k] = source.integer(tag_bytes, "node of an element");
    }
    if (type.use == GmshUse::tet)
    {
        mesh.add_tet(std::span(nodes).first(type.nodes));
    }
}

} // namespace corticle::formats
