// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// A plane through a point, across a direction.
struct Plane
{
    Vec3 point;           ///< [mm]
    Vec3 normal{1, 0, 0}; ///< from left to right
};

/// The plane across x through the middle of the extent of the points: mid-sagittal where x points to the right.
Plane mid_sagittal_plane(std::span<const Vec3> points);

/// Difference of the parts of a body on the two sides of a plane over their mean, (L - R) / ((L + R) / 2) [-]: positive
/// when the left part is larger, 0 for a mirrored body.
struct Asymmetry
{
    double area = 0.0;
    double volume = 0.0;
};

/// Of a closed surface. Triangles that the plane cuts are cut exactly.
Asymmetry asymmetry(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const Plane& plane);

} // namespace corticle::metrics
