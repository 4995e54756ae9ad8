// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// Planes on which contours are measured.
struct SliceOptions
{
    Vec3 normal{0, 1, 0}; ///< y: coronal slices where y points to the front
    int count = 50;       ///< evenly spaced over the extent of the body
};

/// Gyrification of a body cut into slices.
struct SliceGyrification
{
    double index = 0.0;          ///< sum of the whole contours over the sum of the outer contours
    double mean_of_slices = 0.0; ///< mean of whole over outer contour, each slice counting the same
    int slices = 0;              ///< slices that meet the body
};

/// Gyrification index of slices (Zilles et al. 1988, Anat. Embryol. 179): length of the whole contour over that of the
/// outer contour. The outer contour is here the convex hull of the slice, where Zilles draws an envelope over the
/// sulci by hand: where a slice itself is concave or in several pieces, the hull is longer and the index smaller.
/// @throws InputError when the normal is zero or count below 1
SliceGyrification zilles_index(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                               const SliceOptions& options = {});

} // namespace corticle::metrics
