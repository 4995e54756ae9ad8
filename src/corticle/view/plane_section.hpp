// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace corticle::view
{

/// A coordinate plane; its own axes are the other two in the order x, y, z.
struct Plane
{
    int axis = 2;
    double coordinate = 0.0; ///< [mm]

    int right() const { return axis == 0 ? 1 : 0; }
    int up() const { return axis == 2 ? 1 : 2; }
};

/// A piece of the outline of a section [mm], given as (right, up); the body lies on the same side all along a closed
/// outline.
struct Segment
{
    std::array<double, 2> from;
    std::array<double, 2> to;
};

/// Where a surface crosses the plane. Vertices on the plane count as above it, so that closed surfaces give closed
/// outlines.
std::vector<Segment> section_outline(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                     const Plane& plane);

/// Square pixels on the plane, rows from below.
struct PixelGrid
{
    int width = 0;
    int height = 0;
    double left = 0.0;   ///< [mm], of the left edge
    double bottom = 0.0; ///< [mm]
    double pixel = 1.0;  ///< edge of a pixel [mm]

    double right_of(int column) const { return left + (column + 0.5) * pixel; }
    double up_of(int row) const { return bottom + (row + 0.5) * pixel; }
};

/// For each pixel 1 where its centre lies inside the outline (winding number other than zero), 0 elsewhere.
std::vector<std::uint8_t> inside_mask(std::span<const Segment> outline, const PixelGrid& grid);

/// For each pixel of the mask the particle nearest to its centre, in space; -1 outside the mask.
std::vector<std::int32_t> nearest_particles(std::span<const Vec3> particles, const Plane& plane, const PixelGrid& grid,
                                            std::span<const std::uint8_t> mask);

/// How much of each pixel the outline covers, drawn as a soft line: 0 to 1.
std::vector<double> outline_cover(std::span<const Segment> outline, const PixelGrid& grid);

} // namespace corticle::view
