// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <gtest/gtest.h>

#include <span>

namespace corticle::test
{

/// Forces and their torques sum to round-off of what is summed.
inline void expect_momenta_conserved(std::span<const Vec3> x, std::span<const Vec3> forces)
{
    Vec3 force;
    Vec3 torque;
    double force_size = 0.0;
    double torque_size = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        force += forces[i];
        torque += cross(x[i], forces[i]);
        force_size += norm(forces[i]);
        torque_size += norm(x[i]) * norm(forces[i]);
    }
    EXPECT_LT(norm(force), 1e-13 * force_size);
    EXPECT_LT(norm(torque), 1e-13 * torque_size);
}

} // namespace corticle::test
