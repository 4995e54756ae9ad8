// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// An ellipsoid centred at the origin (a sphere when the semi-axes are equal) [mm], triangulated with edges of about
/// the given length. Irregular (no symmetry axis but those of the shape), deterministic; its enclosed volume is 4 pi a
/// b c / 3 to round-off.
TriangleMesh make_ellipsoid(const std::array<double, 3>& semi_axes, double edge_length);

} // namespace corticle::geometry
