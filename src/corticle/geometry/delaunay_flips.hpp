// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// Flips edges of a closed manifold surface until, for each, the two angles opposite to it sum to no more than pi
/// (Lawson), where a flip neither folds the surface nor doubles an edge. Creases and vertices stay,
/// and so do the edges of all triangles at the vertices marked in `stays`, one entry per vertex or none at all.
void flip_to_delaunay(TriangleMesh& mesh, std::span<const char> stays = {});

} // namespace corticle::geometry
