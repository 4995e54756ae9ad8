// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <cstdint>

namespace corticle::geometry
{

/// Orients triangles consistently, stitches rims that coincide, and fills every hole with triangles of the size around
/// it that continue the curvature (CGAL; Liepa 2003). Sheets that meet in an edge or a vertex are cut apart there.
/// Vertices keep their positions. `filled` counts the holes.
/// @throws InputError, one line, when a hole could not be filled.
TriangleMesh orient_and_fill_holes(const TriangleMesh& surface, std::int64_t& filled);

/// Replaces the triangles about places where a closed surface crosses itself by patches that do not, without adding or
/// removing handles (CGAL). False, and the surface as it was, where that failed.
bool remove_self_intersections(TriangleMesh& surface);

} // namespace corticle::geometry
