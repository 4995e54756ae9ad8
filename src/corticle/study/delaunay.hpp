// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <string>

namespace corticle::study
{

/// Body and surface made from bare points, as thesis section 3.2 does it: the 3D Delaunay triangulation (VTK), without
/// the tets whose circumscribed ball is larger than a limit.
struct DelaunayBody
{
    TetMesh mesh;                     ///< all points, and the tets that are kept; right-handed
    TetBoundary boundary;             ///< faces with one tet; may touch itself at edges and vertices, and have hollows
    std::int64_t points_left_out = 0; ///< points of no tet that is kept
};

/// @param points   [mm], finite, at least four that are not in a plane
/// @param largest  radius of the circumscribed balls that are kept [mm]; infinite: all, whose boundary is the convex
/// hull
/// @param name     of the points, in messages
/// @throws InputError when no tet is left
DelaunayBody delaunay_body(std::span<const Vec3> points, double largest, const std::string& name);

} // namespace corticle::study
