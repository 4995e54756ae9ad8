// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <string_view>

namespace corticle::metrics
{

/// Measures of a closed surface.
struct SurfaceMeasures
{
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0;
    double area_per_volume = 0.0; ///< [1/mm]
    double hull_area_mm2 = 0.0;
    double gi_hull = 0.0;         ///< gyrification index: area over the area of the convex hull
    double gi_sphere = 0.0;       ///< gyrification index: area over the area of the sphere of equal volume
    double curved_area_mm2 = 0.0; ///< see curved_size(); so are the next
    double curved_volume_mm3 = 0.0;
    double curved_gi_hull = 0.0; ///< over the same hull
    double curved_gi_sphere = 0.0;
    double length_mm = 0.0; ///< extent along y, from back to front where x points to the right
    double width_mm = 0.0;  ///< extent along x
    double height_mm = 0.0; ///< extent along z
};

SurfaceMeasures measure_surface(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// How much of a surface lies inside another part of the body.
struct Overlap
{
    double area_share =
        0.0; ///< share of the area whose outer side is covered: just off it, the winding number is not 0
    double deepest_penetration = 0.0; ///< largest distance from a covered triangle to the surface it pierced [mm]
    Vec3 place;                       ///< centroid of that triangle
};

/// @param probe_distance  how far off a face the winding number is taken [mm]; small against the distance of banks that
/// touch
Overlap measure_overlap(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double probe_distance);

} // namespace corticle::metrics
