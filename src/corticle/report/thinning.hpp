// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::report
{

/// A coarser surface on some of the vertices of another.
struct ThinSurface
{
    std::vector<std::int32_t> kept;  ///< numbers of the vertices, ascending
    std::vector<Triangle> triangles; ///< in numbers of `kept`
};

/// About `count` of the vertices, evenly spread, and the triangles between them: each kept vertex takes the region of
/// the surface that is nearest to it in edges, and where three regions meet is a triangle. The vertices are to follow
/// a space-filling curve, so that every k-th is an even choice. All are kept where `count` is not below their number.
ThinSurface thin_surface(std::span<const Triangle> triangles, std::size_t vertex_count, std::size_t count);

/// `count` of the numbers from 0 to `all` - 1, evenly spread, the first and the last among them; at least 2 where there
/// are.
std::vector<std::size_t> spread(std::size_t all, std::size_t count);

} // namespace corticle::report
