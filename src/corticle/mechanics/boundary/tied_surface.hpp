// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace corticle::boundary
{

/// A closed surface within a body that moves with its nodes: each vertex is the weighted mean of four of them.
struct TiedSurface
{
    std::vector<std::array<std::int32_t, 4>> nodes;
    std::vector<std::array<double, 4>> weights; ///< of the nodes of a vertex; they sum to 1
    std::vector<Triangle> triangles;            ///< seen from outside counter-clockwise
};

} // namespace corticle::boundary
