// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::imaging
{

/// Evens out triangles and voxel steps of a closed surface without shrinking it: each sweep moves the vertices towards
/// the mean of their neighbours, then a little more than back (Taubin 1995, lambda 0.5, mu -0.53).
void smooth_taubin(TriangleMesh& surface, int sweeps);

} // namespace corticle::imaging
