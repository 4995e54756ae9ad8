// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

namespace corticle
{

/// Tangential growth ratio of a material point [-]: g = 1 + alpha_t theta m t.
constexpr double growth_ratio(double alpha_t, double theta, double regional_rate, double t)
{
    return 1.0 + alpha_t * theta * regional_rate * t;
}

/// Inverse of the growth tensor G = g I + (1 - g) n n^T: tissue grows by g in the plane whose reference normal is n.
/// det G = g². (Tallinen et al. 2016; thesis eq. 22 prints F G where F G^-1 is meant.)
constexpr Mat3 inverse_growth_tensor(double g, const Vec3& normal)
{
    return (1.0 / g) * Mat3::identity() + (1.0 - 1.0 / g) * outer(normal, normal);
}

} // namespace corticle
