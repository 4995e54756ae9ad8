// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/ellipsoid.hpp"

#include "corticle/base/error.hpp"
#include "corticle/material/tissue.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// A lattice in the ellipsoid of semi-axes 6, 4 and 3 about a centre; its ends along the axes are among them.
std::vector<Vec3> ellipsoid_points(const Vec3& centre)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 25 * 17 * 13; ++k)
    {
        const Vec3 r{0.5 * (k / 221) - 6.0, 0.5 * (k / 13 % 17) - 4.0, 0.5 * (k % 13) - 3.0};
        if (r.x * r.x / 36 + r.y * r.y / 16 + r.z * r.z / 9 <= 1.0)
        {
            points.push_back(centre + r);
        }
    }
    return points;
}

TEST(FittedEllipsoid, HasTheExtentsOfTheParticles)
{
    const Vec3 centre{1, -2, 30};
    const std::vector<Vec3> points = ellipsoid_points(centre);
    EXPECT_EQ(prepare::extents_centre(points), centre);
    EXPECT_EQ(prepare::fitted_semi_axes(points), (std::array<double, 3>{6, 4, 3}));
    EXPECT_THROW(prepare::fitted_semi_axes({}), InputError);
    EXPECT_THROW(prepare::extents_centre({}), InputError);
    EXPECT_THROW(prepare::fitted_semi_axes(std::vector<Vec3>{{0, 0, 1}, {1, 1, 1}}), InputError); // flat
}

TEST(FittedEllipsoid, DecidesByTheLevelOfTheParticle)
{
    const std::array<double, 3> axes{6, 4, 3};
    const Vec3 centre{1, 1, 1};
    const std::vector<Vec3> points{centre, {7, 1, 1}, {1, 4, 1}, {1, 3.9, 1}, {1, 1, -0.5}};
    EXPECT_DOUBLE_EQ(prepare::ellipsoid_level(points[2], axes, centre), 0.5625);
    EXPECT_EQ(prepare::ellipsoid_layer_by_centres(points, axes, 0.5625, centre), (std::vector<double>{0, 1, 1, 0, 0}));
}

TEST(FittedEllipsoid, LayerMovesWithTheBody)
{
    const std::vector<Vec3> at_origin = ellipsoid_points({});
    const std::vector<Vec3> elsewhere = ellipsoid_points({10, 20, -5});
    const std::vector<double> cells(at_origin.size(), 0.125);
    const auto axes = prepare::fitted_semi_axes(at_origin);
    const std::vector<double> theta = prepare::ellipsoid_layer(at_origin, cells, axes, 0.75);
    EXPECT_EQ(theta, prepare::ellipsoid_layer(elsewhere, cells, axes, 0.75, prepare::extents_centre(elsewhere)));
    EXPECT_EQ(prepare::ellipsoid_layer_by_centres(at_origin, axes, 0.75),
              prepare::ellipsoid_layer_by_centres(elsewhere, axes, 0.75, prepare::extents_centre(elsewhere)));
    // About the origin of the coordinates all of the moved body would be cortex.
    const std::vector<double> wrong = prepare::ellipsoid_layer_by_centres(elsewhere, axes, 0.75);
    EXPECT_EQ(wrong, std::vector<double>(elsewhere.size(), 1.0));
}

TEST(Layer, BinaryStepOfAnEllipsoid)
{
    // Cells of equal volume, half of which is cortex with lambda = 0.5^(2/3): the outer four of the eight, by the
    // level sum (x/r)² and not by the distance from the centre.
    const std::vector<Vec3> points{{1, 0, 0}, {15, 0, 0},  {0, 1, 0}, {0, 7.5, 0},
                                   {0, 0, 1}, {0, 0, 3.7}, {9, 0, 0}, {0, 0, 3.5}};
    const std::vector<double> theta =
        prepare::ellipsoid_layer(points, std::vector<double>(8, 1.0), {16, 8, 4}, std::pow(0.5, 2.0 / 3.0));
    const std::vector<double> expected{0, 1, 0, 1, 0, 1, 0, 1};
    for (std::size_t i = 0; i < theta.size(); ++i)
    {
        EXPECT_NEAR(theta[i], expected[i], 1e-12) << i;
    }
}

} // namespace
} // namespace corticle
