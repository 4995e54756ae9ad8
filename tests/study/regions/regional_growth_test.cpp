// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/regions/regional_growth.hpp"

#include "corticle/geometry/shapes.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/region_areas.hpp"
#include "corticle/study/regions/nearest_labels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corticle::regions
{
namespace
{

TEST(RegionAreas, OfThreePartsOfASphereAddUp)
{
    const TriangleMesh sphere = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 0.5);
    std::vector<double> labels;
    for (const Vec3& x : sphere.vertices)
    {
        labels.push_back(x.z > 5.0 ? 7.0 : x.z < 0.0 ? -2.0 : 0.0);
    }
    const auto areas = metrics::region_areas({sphere.vertices, sphere.triangles}, labels);
    ASSERT_EQ(areas.size(), 3u);
    const double whole = 4.0 * std::numbers::pi * 100.0;
    EXPECT_NEAR(areas.at(7), 0.25 * whole, 0.02 * whole); // a cap: 2 pi r h
    EXPECT_NEAR(areas.at(-2), 0.5 * whole, 0.02 * whole);
    EXPECT_NEAR(areas.at(7) + areas.at(-2) + areas.at(0), surface_area(sphere.vertices, sphere.triangles), 1e-9);
}

TEST(NearestLabels, TakeTheNearestVoxelThatHasOne)
{
    imaging::LabelVolume volume;
    volume.size = {5, 4, 3};
    volume.frame.linear = Mat3::diagonal(2.0, 1.0, 1.0);
    volume.frame.origin = {-4.0, 0.0, 0.0};
    volume.labels.assign(60, 0);
    volume.labels[1 + 5 * (2 + 4 * 1)] = 3; // at (-2, 2, 1)
    volume.labels[4 + 5 * (2 + 4 * 1)] = 8; // at (4, 2, 1)
    const std::vector<Vec3> places{
        {-2.0, 2.0, 1.0}, {-2.9, 2.4, 1.4}, {0.9, 2.0, 1.0}, {1.1, 2.0, 1.0}, {60.0, 0.0, 0.0}};
    const std::vector<double> labels = nearest_labels(volume, places);
    EXPECT_EQ(labels, (std::vector<double>{3.0, 3.0, 3.0, 8.0, 0.0}));
}

Region region(double first, double wanted, double growth, double area)
{
    return {first, wanted, {{growth, area}}};
}

TEST(RegionalGrowth, NextFactorFollowsTheGrowthInLength)
{
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 400.0, 1.0, 400.0)), 1.0);
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 400.0, 0.8, 225.0)), 1.6);  // 1 wanted, 0.5 came: twice
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 900.0, 1.0, 121.0)), 2.0);  // at most twice
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 101.0, 1.0, 900.0)), 0.5);  // at least half
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 144.0, 0.0, 100.0)), 0.04); // out of nothing
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 400.0, 9.0, 121.0)), 10.0);
    EXPECT_DOUBLE_EQ(next_growth(region(100.0, 81.0, 1.0, 121.0)), 0.5); // it is to shrink
}

TEST(RegionalGrowth, ErrorsAreWeightedWithTheWantedArea)
{
    const Regions regions{{1, region(50.0, 100.0, 1.0, 110.0)}, {2, region(50.0, 300.0, 1.0, 294.0)}};
    const RoundError error = round_error(regions, 0);
    EXPECT_NEAR(error.largest, 0.1, 1e-12);
    EXPECT_NEAR(error.mean, std::sqrt((100.0 * 0.01 + 300.0 * 0.0004) / 400.0), 1e-12);
}

} // namespace
} // namespace corticle::regions
