// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/own_tissue.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// One point whose growth doubles between t = 0.2 and 0.6.
material::GrowthMaps rising_maps()
{
    return {{0.2, 0.6}, {{1.0}, {2.0}}, 0.0};
}

test::OwnTissue tissue_with(const material::GrowthMaps& maps)
{
    test::OwnTissue tissue;
    tissue.options.alpha_t = 1.5;
    tissue.options.alpha_white = 0.2;
    tissue.depth = {0.0};
    tissue.normal = {Vec3{0, 0, 1}};
    tissue.regional_rate = {0.8};
    tissue.theta = {0.7};
    tissue.growth_maps = maps;
    return tissue;
}

TEST(GrowthMaps, AreTheRateOfLinearGrowth)
{
    const test::OwnTissue tissue = tissue_with(rising_maps());
    const double alpha = 0.8 * (1.5 * 0.7 + 0.2 * 0.3);
    EXPECT_NEAR(tissue.point(0, 0.1).growth_rate, alpha, 1e-14);       // before the first map
    EXPECT_NEAR(tissue.point(0, 0.4).growth_rate, 1.5 * alpha, 1e-14); // half way
    EXPECT_NEAR(tissue.point(0, 0.8).growth_rate, 2.0 * alpha, 1e-14); // after the last one
    // 0.2 at 1, 0.4 at 1.5, 0.2 at 2.
    EXPECT_NEAR(tissue.point(0, 0.8).growth, 1.0 + alpha * 1.2, 1e-14);
}

TEST(GrowthMaps, RatesAreThoseOfGrowth)
{
    test::OwnTissue tissue = tissue_with(rising_maps());
    for (const bool by_tissue : {false, true})
    {
        tissue.kind.assign(by_tissue ? 1 : 0, material::TissueKind::white);
        for (const auto law : {material::GrowthLaw::linear, material::GrowthLaw::gompertz})
        {
            tissue.options.growth_law = law;
            for (const double t : {0.1, 0.37, 0.9})
            {
                constexpr double h = 1e-6;
                const material::MaterialPoint now = tissue.point(0, t);
                const material::MaterialPoint later = tissue.point(0, t + h);
                const material::MaterialPoint earlier = tissue.point(0, t - h);
                EXPECT_NEAR(now.growth_rate, (later.growth - earlier.growth) / (2.0 * h), 1e-8);
                EXPECT_NEAR(now.radial_growth_rate, (later.radial_growth - earlier.radial_growth) / (2.0 * h), 1e-8);
            }
        }
    }
}

TEST(GrowthMaps, ThatDoNotChangeAreOneMap)
{
    const test::OwnTissue tissue = tissue_with({{0.1, 0.5}, {{1.3}, {1.3}}, 0.0});
    test::OwnTissue one = tissue_with({});
    one.regional_rate = {0.8 * 1.3};
    EXPECT_NEAR(tissue.point(0, 0.7).growth, one.point(0, 0.7).growth, 1e-14);
    EXPECT_NEAR(tissue.point(0, 0.7).growth_rate, one.point(0, 0.7).growth_rate, 1e-14);
    EXPECT_TRUE(tissue_with({}).growth_maps.times.empty());
    EXPECT_FALSE(tissue.grows_plainly());
}

} // namespace
} // namespace corticle
