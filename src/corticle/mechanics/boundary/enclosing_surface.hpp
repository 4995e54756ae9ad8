// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <span>
#include <vector>

namespace corticle::boundary
{

/// The volume that a closed surface encloses, and how it changes with the positions of its vertices:
///
///     V = 1/6 sum over triangles of x_a . (x_b x x_c)
///     dV/dx_a = 1/6 sum over the triangles at a of x_b x x_c
///
/// both about a point of the surface, so that they do not lose digits far from the origin.
class EnclosingSurface
{
  public:
    EnclosingSurface(std::span<const Triangle> triangles, std::size_t vertices);

    /// Sets volume and gradient at these positions [mm].
    void evaluate(std::span<const Vec3> x);

    double volume() const { return volume_; }                    ///< [mm³]
    std::span<const Vec3> gradient() const { return gradient_; } ///< one for each vertex [mm²]

  private:
    std::vector<Triangle> triangles_;
    std::vector<std::int32_t> begin_;                   ///< of the corners at each vertex
    std::vector<std::array<std::int32_t, 2>> opposite_; ///< the other two of the triangle, in its order
    std::vector<Vec3> gradient_;
    double volume_ = 0.0;
};

} // namespace corticle::boundary
