// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/options.hpp"
#include "corticle/prepare/prepare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corticle
{
namespace
{

/// zeta in force over solver.zeta, of a ball with this many spacings through the cortex.
double control(double spacings)
{
    config::Options options;
    options.geometry.shape = prepare::Shape::sphere;
    options.geometry.radius_mm = 8.0;
    options.geometry.spacing_mm = 1.0;
    options.tissue.thickness_mm = spacings * std::cbrt(4.0 / 3.0 * std::numbers::pi * 512.0 / 2145.0);
    const model::Model model = prepare::prepare_body(options).model;
    return model.particles.options.zeta / options.tlsph.zeta;
}

TEST(ZeroEnergyControl, IsStrongerInCoarseAndInFineClouds)
{
    EXPECT_NEAR(control(1.5), 4.0, 0.02);
    EXPECT_EQ(control(3.1), 1.0);
    EXPECT_EQ(control(4.0), 1.0);
    EXPECT_NEAR(control(4.92), std::pow(1.2, 4), 0.02);
    EXPECT_EQ(control(6.5), 5.0);
}

} // namespace
} // namespace corticle
