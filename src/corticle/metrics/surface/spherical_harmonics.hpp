// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <span>
#include <vector>

namespace corticle::metrics
{

/// Power of a function on the sphere by degree l = 0 … largest_degree: the mean square of its part of that degree, in
/// real spherical harmonics; their sum is the mean square of the function. Legendre functions by the normalised
/// recurrence (Holmes & Featherstone 2002, J. Geodesy 76, eq. 11).
/// @param directions  unit vectors
/// @param areas       share of the sphere at each direction, any unit
std::vector<double> power_by_degree(std::span<const Vec3> directions, std::span<const double> values,
                                    std::span<const double> areas, int largest_degree);

/// Degree with the most power, 0 left out; 0 where there is none.
int dominant_degree(std::span<const double> power);

} // namespace corticle::metrics
