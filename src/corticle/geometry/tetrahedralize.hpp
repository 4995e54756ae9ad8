// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

namespace corticle
{

/// Fills a closed surface with tetrahedra (Gmsh, HXT: Marot, Pellerin & Remacle 2019). The vertices of the surface are
/// the first nodes, in their order, and its triangles the boundary of the tets. The same for any number of threads.
/// @param nodes  about this many, those on the surface included; at least as many as it has vertices
/// @throws InputError where Gmsh cannot fill the surface
TetMesh tetrahedralize(const TriangleMesh& surface, std::int64_t nodes);

/// Number of nodes at which `tetrahedralize` gives about this many tets to a body, met within 3 %, 8 % below 20,000.
/// @param volume, area      of the body [mm³, mm²]
/// @param edge_per_spacing  edges of its surface over the cube root of the volume per node
std::int64_t nodes_for_tets(std::int64_t tets, double volume, double area, double edge_per_spacing);

} // namespace corticle
