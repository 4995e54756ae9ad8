// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <array>
#include <span>
#include <vector>

namespace corticle::prepare
{

// The layer of thesis section 2.4.1.

/// Middle of the extents of points along each axis [mm]. Thesis eq. 24 takes it for the origin, which holds for a
/// sphere about the origin and not for a body in scanner coordinates.
/// @throws InputError when there are no points
Vec3 extents_centre(std::span<const Vec3> points);

/// Semi-axes of the ellipsoid of thesis eq. 24: half of the extents of points along each axis [mm].
/// @throws InputError when there are no points, or all lie in a plane across an axis
std::array<double, 3> fitted_semi_axes(std::span<const Vec3> points);

/// sum_k ((X_k - c_k) / r_k)², the left side of thesis eq. 24: 0 at the centre, 1 on the ellipsoid.
double ellipsoid_level(const Vec3& X, const std::array<double, 3>& semi_axes, const Vec3& centre);

/// Cortex as thesis eq. 24 decides it: 1 where the level of the particle itself is at least lambda, else 0, whatever
/// the volume of the cortex becomes by that.
std::vector<double> ellipsoid_layer_by_centres(std::span<const Vec3> positions, const std::array<double, 3>& semi_axes,
                                               double lambda, const Vec3& centre = {});

/// Binary cortex of an ellipsoid (thesis eq. 24), sum_k ((X_k - c_k) / r_k)² >= lambda, with the volume it has there.
/// @param volume     [mm³], one per particle
/// @param semi_axes  r [mm], those of the shape or those fitted to the particles
/// @param centre     c [mm]
std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> volume,
                                    const std::array<double, 3>& semi_axes, double lambda, const Vec3& centre = {});

} // namespace corticle::prepare
