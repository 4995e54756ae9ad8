// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// Convex hull of points [mm] (CGAL).
TriangleMesh convex_hull(std::span<const Vec3> points);

} // namespace corticle::geometry
