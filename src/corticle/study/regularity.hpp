// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>

namespace corticle::study
{

/// How evenly particles are spread, and what that means for the gradient correction. Distances are in spacings.
struct Regularity
{
    std::int64_t particles = 0;
    double closest_pair = 0.0;
    double nearest_mean = 0.0;        ///< distance to the nearest other particle
    double nearest_variation = 0.0;   ///< its standard deviation over its mean
    double neighbors_variation = 0.0; ///< the same of the number of neighbours, of particles deeper than the support
    std::int64_t fewest_neighbors = 0;
    double worst_condition = 0.0;     ///< of the shape matrices, volumes all equal; infinite when one is singular
    std::int64_t ill_conditioned = 0; ///< particles whose condition is above largest_condition
};

/// Measures a cloud.
/// @param positions  reference [mm], at least two
/// @param depths     distances of the particles to the surface [mm]
/// @param spacing    cube root of the body's volume per particle [mm]
/// @param support    of the kernel [mm]
Regularity measure_regularity(std::span<const Vec3> positions, std::span<const double> depths, double spacing,
                              double support);

} // namespace corticle::study
