// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/tissue/tissue.hpp"

#include "corticle/tissue/layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

TEST(Layer, SmoothStepOfTheThesis)
{
    // 1 / (1 + exp(10 (y/H - 1))) at y = 0, H/2, H, 3H/2 and 2H.
    EXPECT_DOUBLE_EQ(smooth_layer(0.0, 1.674), 1.0 / (1.0 + std::exp(-10.0)));
    EXPECT_NEAR(smooth_layer(0.837, 1.674), 0.9933071490757153, 1e-15);
    EXPECT_DOUBLE_EQ(smooth_layer(1.674, 1.674), 0.5);
    EXPECT_NEAR(smooth_layer(2.511, 1.674), 0.0066928509242848554, 1e-15);
    EXPECT_NEAR(smooth_layer(3.348, 1.674), 4.5397868702434395e-05, 1e-15);
    EXPECT_EQ(smooth_layer(1e6, 1.0), 0.0); // far inside: no NaN from the exponential
}

TEST(Layer, BinaryStep)
{
    // The share of a cell of width 0.5 whose centre lies so far inside the boundary.
    EXPECT_EQ(binary_layer(1.0, 0.5), 1.0);
    EXPECT_EQ(binary_layer(0.25, 0.5), 1.0);
    EXPECT_DOUBLE_EQ(binary_layer(0.125, 0.5), 0.75);
    EXPECT_DOUBLE_EQ(binary_layer(0.0, 0.5), 0.5);
    EXPECT_EQ(binary_layer(-0.25, 0.5), 0.0);
}

TEST(Layer, BinaryStepOfAnEllipsoid)
{
    // Sphere of the thesis: lambda = 0.75 puts the inner radius at 12.496 sqrt(0.75) = 10.8219 mm.
    const std::vector<Vec3> radii{{0, 0, 0}, {10.821, 0, 0}, {0, 10.823, 0}, {0, 0, 12.496}};
    const std::vector<double> narrow(6, 1e-3); // cells so narrow that the step is sharp
    EXPECT_EQ(ellipsoid_layer(radii, narrow, {12.496, 12.496, 12.496}, 0.75), (std::vector<double>{0, 0, 1, 1}));
    // On the axes of an ellipsoid the step lies at sqrt(lambda) of each semi-axis.
    const std::vector<Vec3> points{{7.9, 0, 0}, {8.1, 0, 0}, {0, 3.9, 0}, {0, 4.1, 0}, {0, 0, 1.9}, {0, 0, 2.1}};
    EXPECT_EQ(ellipsoid_layer(points, narrow, {16, 8, 4}, 0.25), (std::vector<double>{0, 1, 0, 1, 0, 1}));
    // A wide cell a tenth of a millimetre outside the step: 0.5 + 0.1 / 0.5 of it is cortex.
    const std::vector<Vec3> near_step{{8.1, 0, 0}};
    EXPECT_NEAR(ellipsoid_layer(near_step, std::vector<double>{0.5}, {16, 8, 4}, 0.25)[0], 0.7, 1e-12);
}

TEST(Tissue, ThicknessFollowsItsRate)
{
    Tissue tissue;
    tissue.options.layer = Layer::smooth;
    tissue.options.thickness_mm = 1.5;
    tissue.options.thickness_rate_mm = 0.8;
    tissue.depth = {0.0, 1.5, 1.9, 2.3};
    tissue.cell_width.assign(4, 1e-3);
    tissue.set_layer(0.5); // H = 1.9
    for (std::size_t i = 0; i < tissue.depth.size(); ++i)
    {
        EXPECT_DOUBLE_EQ(tissue.theta[i], 1.0 / (1.0 + std::exp(10.0 * (tissue.depth[i] / 1.9 - 1.0))));
    }
    tissue.options.layer = Layer::binary;
    tissue.set_layer(0.0);
    EXPECT_EQ(tissue.theta, (std::vector<double>{1, 0.5, 0, 0}));
    tissue.set_layer(0.6); // H = 1.98
    EXPECT_EQ(tissue.theta, (std::vector<double>{1, 1, 1, 0}));
}

TEST(Tissue, BothBulkRules)
{
    TissueOptions options;
    options.mu_cortex = 0.86;
    options.mu_white = 1.2;
    options.bulk_modulus = 5.0;
    options.alpha_t = 1.5;
    options.bulk = BulkRule::per_tissue;
    const MaterialPoint mixed = material_point(options, 0.25, 0.8, 0.5);
    EXPECT_DOUBLE_EQ(mixed.shear_modulus, 0.25 * 0.86 + 0.75 * 1.2);
    EXPECT_DOUBLE_EQ(mixed.bulk_modulus, 5.0 * mixed.shear_modulus);
    EXPECT_DOUBLE_EQ(mixed.growth, 1.15);
    options.bulk = BulkRule::uniform;
    EXPECT_DOUBLE_EQ(material_point(options, 0.25, 0.8, 0.5).bulk_modulus, 5.0);
    EXPECT_DOUBLE_EQ(material_point(options, 1.0, 1.0, 0.0).shear_modulus, 0.86);
}

TEST(Tissue, WaveSpeedOfTheWhiteMatter)
{
    TissueOptions options;
    options.mu_white = 1.2;
    options.bulk_modulus = 5.0;
    options.bulk = BulkRule::per_tissue;
    EXPECT_DOUBLE_EQ(wave_speed(options), std::sqrt(6.0 + 1.6));
    options.bulk = BulkRule::uniform;
    EXPECT_DOUBLE_EQ(wave_speed(options), std::sqrt(5.0 + 1.6));
}

} // namespace
} // namespace corticle
