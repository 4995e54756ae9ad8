// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/cloud.hpp"

namespace corticle::cloud
{

/// How even a cloud is.
struct CloudQuality
{
    double closest_pair_spacings = 0.0; ///< distance of the closest pair of particles, in spacings
    double smallest_volume = 0.0;       ///< [mm³]
    double mean_volume = 0.0;           ///< [mm³]
    double largest_volume = 0.0;        ///< [mm³]
};

CloudQuality measure_quality(const Cloud& cloud);

} // namespace corticle::cloud
