// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// An ellipsoid centred at the origin (a sphere when the semi-axes are equal) [mm], triangulated with edges of about
/// the given length. Irregular (no symmetry axis but those of the shape), deterministic; its enclosed volume is 4 pi a
/// b c / 3 to round-off.
TriangleMesh make_ellipsoid(const std::array<double, 3>& semi_axes, double edge_length);

/// A box about the origin [mm], triangulated with edges of about the given length, the diagonals of neighbouring
/// squares crossing; deterministic.
TriangleMesh make_box(const Vec3& size, double edge_length);

} // namespace corticle::geometry
