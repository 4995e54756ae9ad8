// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

struct CurvedSize
{
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0; ///< enclosed
};

/// Size of the smooth surface through the vertices of a closed surface: each triangle stands for a cubic patch that
/// bends as the vertex normals at its corners say. Exact to fourth order in the length of edges where the surface is
/// smooth; flat triangles, which cut the corners of folds, are to second. Volumes of bodies with sharp edges are too
/// large by what rounding the edges over one triangle adds. See docs/theory/metrics.md.
CurvedSize curved_size(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

} // namespace corticle::metrics
