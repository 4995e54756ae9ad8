// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/number_source.hpp"
#include "corticle/formats/tets/tet_formats.hpp"

namespace corticle::formats
{

/// What becomes of the elements of a Gmsh file.
enum class GmshUse
{
    tet,
    flat, ///< points, lines, faces: left out
    solid ///< other solids: refused
};

/// A type of element of the Gmsh reference manual.
struct GmshElementType
{
    std::int64_t number;
    std::size_t nodes;
    GmshUse use;
    std::string_view name;
};

/// @throws InputError, naming the place, for an unknown type or a solid that is not a tet.
const GmshElementType& gmsh_element_type(std::int64_t number, const NumberSource& source);

/// Takes the nodes of one element, each of `tag_bytes` bytes, and adds it when it is a tet.
void take_gmsh_element(NumberSource& source, const GmshElementType& type, int tag_bytes, TetBuilder& mesh);

} // namespace corticle::formats
