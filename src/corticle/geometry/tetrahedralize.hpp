// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

namespace corticle::geometry
{

/// Fills a closed surface with tetrahedra (Gmsh, HXT: Marot, Pellerin & Remacle 2019). The vertices of the surface are
/// the first nodes, in their order, and its triangles the boundary of the tets. The same for any number of threads.
/// @param nodes  about this many, those on the surface included; at least as many as it has vertices
/// Gmsh works in a program of its own, corticle-tetrahedralize: beside the running one, in ../libexec/corticle from
/// there, or where the environment variable CORTICLE_TETRAHEDRALIZE says.
/// @throws InputError where Gmsh cannot fill the surface, RunError where the program is missing or crashes,
///         std::bad_alloc where it has too little memory
TetMesh tetrahedralize(const TriangleMesh& surface, std::int64_t nodes);

/// Number of nodes at which `tetrahedralize` gives about this many tets to a body, met within 3 %, 8 % below 20,000.
/// @param volume, area      of the body [mm³, mm²]
/// @param edge_per_spacing  edges of its surface over the cube root of the volume per node
std::int64_t nodes_for_tets(std::int64_t tets, double volume, double area, double edge_per_spacing);

} // namespace corticle::geometry
