// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <vector>

namespace corticle::geometry
{

/// Boundary edges that hang together.
struct SurfaceHole
{
    std::int64_t edges = 0;
    double length_mm = 0.0; ///< of its rim
    double radius_mm = 0.0; ///< of a circle as wide as the rim is long, or of the rim's bounding box, whichever is less
};

/// What edges say about any set of triangles.
struct EdgeFaults
{
    std::int64_t boundary_edges = 0; ///< with one triangle
    std::int64_t crowded_edges = 0;  ///< with more than two
    std::int64_t opposed_edges = 0;  ///< between two triangles of opposite sense
    std::vector<SurfaceHole> holes;  ///< longest rim first
};
EdgeFaults find_edge_faults(const TriangleMesh& surface);

/// Number of the shell of each triangle: triangles that share vertices hang together. Shells are numbered by their
/// first triangle.
std::vector<std::int32_t> shells_of(const TriangleMesh& surface);

/// The triangles for which `keep` is not 0, and the vertices they use, in their order.
TriangleMesh kept_triangles(const TriangleMesh& surface, const std::vector<char>& keep);

/// Merges vertices that lie closer together than `distance` [mm] and drops triangles that collapse.
TriangleMesh merge_within(const TriangleMesh& surface, double distance);

/// Keeps one of each set of triangles with the same three vertices.
TriangleMesh drop_repeated_triangles(const TriangleMesh& surface);

/// Removes the triangles around vertices where two holes touch, so that these become one hole with a simple rim.
TriangleMesh open_pinched_holes(const TriangleMesh& surface);

/// Length of the diagonal of the bounding box [mm].
double bounding_diagonal(const TriangleMesh& surface);

} // namespace corticle::geometry
