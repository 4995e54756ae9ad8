// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

struct RemeshReport
{
    double area_change = 0.0;         ///< (new - old) / old
    double volume_change = 0.0;       ///< (new - old) / old
    double largest_distance_mm = 0.0; ///< of a new vertex or centroid to the old surface
};

/// Isotropic remeshing of a closed surface to edges of the given length [mm] (CGAL, Botsch & Kobbelt 2004).
/// Throws InputError when the result is not closed, embedded and of positive volume.
TriangleMesh remesh_isotropic(const TriangleMesh& surface, double edge_length, RemeshReport* report = nullptr);

} // namespace corticle::geometry
