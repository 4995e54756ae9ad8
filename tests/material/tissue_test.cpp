// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue.hpp"

#include "corticle/material/layer.hpp"

#include "material/own_tissue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

TEST(Layer, SmoothStepOfTheThesis)
{
    // 1 / (1 + exp(10 (y/H - 1))) at y = 0, H/2, H, 3H/2 and 2H.
    EXPECT_DOUBLE_EQ(material::smooth_layer(0.0, 1.674), 1.0 / (1.0 + std::exp(-10.0)));
    EXPECT_NEAR(material::smooth_layer(0.837, 1.674), 0.9933071490757153, 1e-15);
    EXPECT_DOUBLE_EQ(material::smooth_layer(1.674, 1.674), 0.5);
    EXPECT_NEAR(material::smooth_layer(2.511, 1.674), 0.0066928509242848554, 1e-15);
    EXPECT_NEAR(material::smooth_layer(3.348, 1.674), 4.5397868702434395e-05, 1e-15);
    EXPECT_EQ(material::smooth_layer(1e6, 1.0), 0.0); // far inside: no NaN from the exponential
}

TEST(Layer, SharpStepKeepsTheVolumeOfTheCortex)
{
    // Unit cells at depths 0.3, 0.9, 1.8 and 2.4 under a boundary at 1.5: of the second cell 1, of the third 0.2 lies
    // inside, so 2.2 cells are cortex.
    const std::vector<double> inside{1.2, -0.3, 0.6, -0.9};
    const std::vector<double> cells(4, 1.0);
    EXPECT_NEAR(material::volume_inside(inside, cells), 2.2, 1e-15);
    const std::vector<double> theta = material::sharp_layer(inside, cells, 2.2);
    EXPECT_EQ(theta[0], 1.0);
    EXPECT_EQ(theta[2], 1.0);
    EXPECT_NEAR(theta[1], 0.2, 1e-15);
    EXPECT_EQ(theta[3], 0.0);
}

TEST(Tissue, ThicknessFollowsItsRate)
{
    test::OwnTissue tissue;
    tissue.options.layer = material::Layer::smooth;
    tissue.options.thickness_mm = 1.5;
    tissue.options.thickness_rate_mm = 0.8;
    tissue.depth = {0.0, 1.5, 1.9, 2.3};
    tissue.volume.assign(4, 1e-9);
    tissue.set_layer(0.5); // H = 1.9
    for (std::size_t i = 0; i < tissue.depth.size(); ++i)
    {
        EXPECT_DOUBLE_EQ(tissue.theta[i], 1.0 / (1.0 + std::exp(10.0 * (tissue.depth[i] / 1.9 - 1.0))));
    }
    tissue.options.layer = material::Layer::binary;
    tissue.set_layer(0.0);
    EXPECT_NEAR(tissue.theta[1], 0.5, 1e-9); // its cell is cut in half
    EXPECT_EQ(tissue.theta[0] + tissue.theta[2] + tissue.theta[3], 1.0);
    tissue.set_layer(0.6); // H = 1.98
    EXPECT_NEAR(tissue.theta[2], 1.0, 1e-9);
    EXPECT_EQ(tissue.theta[3], 0.0);
}

TEST(Tissue, BothBulkRules)
{
    material::TissueOptions options;
    options.mu_cortex = 0.86;
    options.mu_white = 1.2;
    options.bulk_modulus = 5.0;
    options.alpha_t = 1.5;
    options.bulk = material::BulkRule::per_tissue;
    const material::MaterialPoint mixed = material::material_point(options, 0.25, 0.8, 0.5);
    EXPECT_DOUBLE_EQ(mixed.shear_modulus, 0.25 * 0.86 + 0.75 * 1.2);
    EXPECT_DOUBLE_EQ(mixed.bulk_modulus, 5.0 * mixed.shear_modulus);
    EXPECT_DOUBLE_EQ(mixed.growth, 1.15);
    options.bulk = material::BulkRule::uniform;
    EXPECT_DOUBLE_EQ(material::material_point(options, 0.25, 0.8, 0.5).bulk_modulus, 5.0);
    EXPECT_DOUBLE_EQ(material::material_point(options, 1.0, 1.0, 0.0).shear_modulus, 0.86);
}

TEST(Tissue, WaveSpeedOfTheWhiteMatter)
{
    material::TissueOptions options;
    options.mu_white = 1.2;
    options.bulk_modulus = 5.0;
    options.bulk = material::BulkRule::per_tissue;
    EXPECT_DOUBLE_EQ(material::wave_speed(options), std::sqrt(6.0 + 1.6));
    options.bulk = material::BulkRule::uniform;
    EXPECT_DOUBLE_EQ(material::wave_speed(options), std::sqrt(5.0 + 1.6));
}

} // namespace
} // namespace corticle
