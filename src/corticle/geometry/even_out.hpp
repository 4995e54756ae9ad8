// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"

namespace corticle::geometry
{

/// Makes the edges of a closed mesh of about the right size more equal: vertices push the ones they share an edge with
/// along the surface and return to its closest point, and edges flip to Delaunay in between. `edge_length` in mm.
/// Makes no self-intersections: where some would arise, or if they arise everywhere, the mesh stays as it is.
void even_out(TriangleMesh& mesh, const SurfaceTree& surface, double edge_length);

} // namespace corticle::geometry
