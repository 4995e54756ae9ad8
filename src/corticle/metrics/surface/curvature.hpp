// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// Curvature at the vertices of a surface. Positive where the surface bulges outward: a sphere of radius R has mean
/// curvature 1/R everywhere, gyri are positive and sulci negative.
struct Curvature
{
    std::vector<double> mean;        ///< H = (k1 + k2) / 2 [1/mm]
    std::vector<double> gaussian;    ///< K = k1 k2 [1/mm²]
    std::vector<double> shape_index; ///< 2/pi atan((k1 + k2) / (k1 - k2)), k1 >= k2, in [-1, 1]: cup -1, rut -0.5,
                                     ///< saddle 0, ridge 0.5, cap 1 (Koenderink & van Doorn 1992) [-]
    std::vector<double> curvedness;  ///< sqrt((k1² + k2²) / 2) (the same) [1/mm]
};

/// Curvature of a closed surface from the quadric that fits the two rings of neighbours of each vertex best, as a graph
/// over its tangent plane: Weingarten map of the osculating jet of degree 2 (Cazals & Pouget 2005, Computer Aided
/// Geometric Design 22).
Curvature vertex_curvature(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

} // namespace corticle::metrics
