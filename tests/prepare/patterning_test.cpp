// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/patterning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corticle
{

namespace
{

/// Evenly spread over the sphere.
std::vector<Vec3> fibonacci_sphere(int count)
{
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i)
    {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt(1.0 - z * z);
        directions.push_back({r * std::cos(golden * i), r * std::sin(golden * i), z});
    }
    return directions;
}

} // namespace

TEST(GrowthModes, AreOrthonormalOverDirections)
{
    const std::vector<Vec3> directions = fibonacci_sphere(20000);
    for (std::size_t a = 0; a < prepare::growth_mode_count; ++a)
    {
        for (std::size_t b = 0; b <= a; ++b)
        {
            double product = 0.0;
            for (const Vec3& direction : directions)
            {
                product += prepare::growth_mode(a, direction) * prepare::growth_mode(b, direction) / 20000.0;
            }
            EXPECT_NEAR(product, a == b ? 1.0 : 0.0, 1e-3) << a << " and " << b;
        }
    }
}

TEST(GrowthModes, MultiplyGrowthInTheDirectionOfTheSurface)
{
    // Points half way out in directions of the axes, about a centre that is not the origin.
    const Vec3 centre{3.0, -2.0, 1.0};
    const std::vector<Vec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Vec3> places;
    material::TissueFields tissue;
    for (const Vec3& axis : axes)
    {
        places.push_back(centre + 5.0 * axis);
        tissue.depth.push_back(5.0);
        tissue.normal.push_back(axis);
        tissue.volume.push_back(2.0);
        tissue.regional_rate.push_back(2.0);
    }
    const material::TissueFields before = tissue;
    prepare::apply_modes({}, places, tissue);
    EXPECT_EQ(tissue.regional_rate, before.regional_rate);

    prepare::apply_modes(std::vector<double>{0.1, 0.0, -0.2}, places, tissue); // to the front, and to the left
    const double root = std::sqrt(3.0);
    const std::vector<double> expected{-0.2 * root, 0.2 * root, 0.1 * root, -0.1 * root, 0.0, 0.0};
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
        EXPECT_NEAR(tissue.regional_rate[k], 2.0 * (1.0 + expected[k]), 1e-12) << k;
    }

    prepare::apply_modes(std::vector<double>{0.0, 0.0, 1.0}, places, tissue);
    EXPECT_EQ(tissue.regional_rate[1], 0.0); // 1 - sqrt(3) would shrink
}

} // namespace corticle
