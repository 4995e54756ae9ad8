// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cells.hpp"
#include "corticle/mesh/cloud.hpp"

#include <span>

namespace corticle::cloud
{

/// A cloud of points [mm] with their cells, numbered along a space-filling curve. The first points are the
/// vertices of the surface. The spacing is the cube root of the volume per particle.
/// @param particle_of  out, the particle that each point became; null if not wanted
Cloud ordered_cloud(std::span<const Vec3> points, const Cells& cells, const TriangleMesh& surface,
                    std::vector<std::int32_t>* particle_of = nullptr);

} // namespace corticle::cloud
