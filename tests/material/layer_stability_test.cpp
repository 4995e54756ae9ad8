// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/layer_stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corticle
{
namespace
{

material::CriticalLayer layer_of(double mu_cortex, double bulk_modulus)
{
    material::TissueOptions options;
    options.mu_cortex = mu_cortex;
    options.bulk_modulus = bulk_modulus;
    return material::critical_layer(options);
}

TEST(LayerStability, TheLayerOfTheThesisFoldsAsAnIndependentAnalysisSays)
{
    // Shooting through the layer on a spectral half-space: g = 1.3805 at a wavelength of 4.65 thicknesses.
    const material::CriticalLayer layer = layer_of(0.86, 5.0);
    EXPECT_NEAR(layer.growth, 1.3805, 2e-4);
    EXPECT_NEAR(layer.wavelength / 4.65, 1.0, 0.04); // the minimum is flat, and wavelengths are 4 % apart
}

TEST(LayerStability, AStiffLayerWrinklesAsAThinPlate)
{
    // Plate on a half-space, E* = E / (1 - nu²): force a width E_c* h / 4 (3 E_w* / E_c*)^(2/3), which a biaxial strain
    // e gives as E_c e h / (1 - nu); wavelength 2 pi h (E_c* / (3 E_w*))^(1/3).
    const double ratio = 300.0;
    const double nu = (3.0 * 5.0 - 2.0) / (2.0 * (3.0 * 5.0 + 1.0));
    const double strain = 0.25 / (1.0 + nu) * std::pow(3.0 / ratio, 2.0 / 3.0);
    const material::CriticalLayer layer = layer_of(ratio, 5.0);
    EXPECT_NEAR((layer.growth - 1.0) / strain, 1.0, 0.05); // shear on the plate's underside is left out
    EXPECT_NEAR(layer.wavelength / (2.0 * std::numbers::pi * std::cbrt(ratio / 3.0)), 1.0, 0.05);
}

TEST(LayerStability, ASofterOrMoreCompressibleLayerFoldsLaterOrNever)
{
    EXPECT_GT(layer_of(0.5, 5.0).growth, layer_of(0.86, 5.0).growth);
    EXPECT_GT(layer_of(0.86, 5.0).growth, layer_of(3.0, 5.0).growth);
    EXPECT_GT(layer_of(0.86, 5.0).growth, layer_of(0.86, 50.0).growth);
    EXPECT_TRUE(std::isinf(layer_of(0.86, 1.0).growth));
}

} // namespace
} // namespace corticle
