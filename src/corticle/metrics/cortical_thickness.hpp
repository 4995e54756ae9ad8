// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// Particles of a body in the reference and the current configuration.
struct CarriedCloud
{
    std::span<const Vec3> reference; ///< X [mm]
    std::span<const Vec3> current;   ///< x [mm]
    std::span<const Mat3> F;         ///< deformation gradients
    double spacing = 0.0;            ///< of the reference [mm]
};

/// Where the body has carried material points to [mm]: x_i + F_i (X - X_i), averaged over the particles within 1.5
/// spacings with the weight (1 - (d / 1.5 spacings)²)²; exact for an affine motion.
/// @param points  reference positions inside the body [mm]
std::vector<Vec3> carried_points(const CarriedCloud& cloud, std::span<const Vec3> points);

/// Thickness at each vertex of the outer surface of the cortex [mm]: mean of the distance from the vertex to the inner
/// surface and that from the matching inner vertex back to the outer surface (Fischl & Dale 2000, PNAS 97).
/// @param inner  the boundary of grey and white matter: one vertex for each outer one, same triangles
std::vector<double> cortical_thickness(std::span<const Vec3> outer, std::span<const Vec3> inner,
                                       std::span<const Triangle> triangles);

} // namespace corticle::metrics
