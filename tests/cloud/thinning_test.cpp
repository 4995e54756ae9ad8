// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/thinning.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/mesh/point_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace corticle
{
namespace
{

/// A unit cube at random, where x < 0.5 holds `contrast` times as many points as the other half.
std::vector<Vec3> uneven_points(std::uint64_t count, double contrast)
{
    std::vector<Vec3> points;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        const bool dense = hash_uniform(5, 4 * k + 3) < contrast / (1.0 + contrast);
        points.push_back({0.5 * hash_uniform(5, 4 * k) + (dense ? 0.0 : 0.5), hash_uniform(5, 4 * k + 1),
                          hash_uniform(5, 4 * k + 2)});
    }
    return points;
}

std::vector<Vec3> chosen(std::span<const Vec3> points, std::span<const std::int32_t> kept)
{
    std::vector<Vec3> subset;
    for (const std::int32_t i : kept)
    {
        subset.push_back(points[i]);
    }
    return subset;
}

double share_below_half(std::span<const Vec3> points)
{
    return static_cast<double>(std::count_if(points.begin(), points.end(), [](const Vec3& p) { return p.x < 0.5; })) /
           static_cast<double>(points.size());
}

double closest_pair(std::span<const Vec3> points)
{
    const PointTree tree(points);
    double closest = 1e300;
    for (const Vec3& p : points)
    {
        closest = std::min(closest, std::sqrt(tree.nearest_squared<2>(p)[1]));
    }
    return closest;
}

/// Exactly `count` indices of the points, ascending, none twice.
void expect_a_subset(std::span<const std::int32_t> kept, std::int64_t count, std::size_t points)
{
    ASSERT_EQ(std::ssize(kept), count);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), std::less_equal<>{}));
    EXPECT_GE(kept.front(), 0);
    EXPECT_LT(kept.back(), static_cast<std::int32_t>(points));
}

using Thinning = std::vector<std::int32_t> (*)(std::span<const Vec3>, std::int64_t, std::uint64_t);
class EveryThinning : public testing::TestWithParam<Thinning>
{
};
INSTANTIATE_TEST_SUITE_P(Thinning, EveryThinning, testing::Values(&cloud::thin_random, &cloud::thin_uniform));

TEST_P(EveryThinning, KeepsExactlyTheNumberAskedFor)
{
    const std::vector<Vec3> points = uneven_points(3000, 3.0);
    for (const std::int64_t count : {1, 2, 700, 2999, 3000})
    {
        expect_a_subset(GetParam()(points, count, 1), count, points.size());
    }
    for (const std::int64_t few : {1, 2, 3})
    {
        expect_a_subset(GetParam()(std::span(points).first(3), few, 1), few, 3);
    }
    expect_a_subset(GetParam()(std::vector<Vec3>(2000, Vec3{1, 2, 3}), 500, 1), 500, 2000); // all in one place
    EXPECT_THROW(GetParam()(points, 0, 1), InputError);
    EXPECT_THROW(GetParam()(points, 3001, 1), InputError);
    EXPECT_THROW(GetParam()({}, 1, 1), InputError);
}

TEST_P(EveryThinning, MakesAnUnevenDensityUniform)
{
    // Four fifths of the points are in one half; after thinning it holds half of them. Chance alone: 0.5 ± 0.011.
    const std::vector<Vec3> points = uneven_points(40000, 4.0);
    ASSERT_GT(share_below_half(points), 0.79);
    EXPECT_NEAR(share_below_half(chosen(points, GetParam()(points, 2000, 1))), 0.5, 0.03);
}

TEST_P(EveryThinning, DependsOnTheSeedAndNotOnTheThreads)
{
    // A lattice, on which many points are equally crowded.
    std::vector<Vec3> points;
    for (int k = 0; k < 4096; ++k)
    {
        points.push_back({k / 256 * 1.0, k / 16 % 16 * 1.0, k % 16 * 1.0});
    }
    const int threads = thread_count();
    set_thread_count(1);
    const std::vector<std::int32_t> one = GetParam()(points, 1000, 1);
    set_thread_count(2);
    EXPECT_EQ(one, GetParam()(points, 1000, 1));
    set_thread_count(threads);
    EXPECT_NE(one, GetParam()(points, 1000, 2));
}

TEST(Thinning, EliminationKeepsPointsApartAndChanceDoesNot)
{
    const std::vector<Vec3> points = uneven_points(20000, 1.0);
    const double spacing = std::cbrt(1.0 / 2000.0);
    EXPECT_GT(closest_pair(chosen(points, cloud::thin_uniform(points, 2000, 1))), 0.6 * spacing);
    EXPECT_LT(closest_pair(chosen(points, cloud::thin_random(points, 2000, 1))), 0.2 * spacing);
}

TEST(PointTree, FindsTheNearestAsASearchThroughAllDoes)
{
    const std::vector<Vec3> points = uneven_points(500, 20.0);
    const PointTree tree(points);
    for (std::uint64_t k = 0; k < 50; ++k)
    {
        const Vec3 place{hash_uniform(8, 3 * k), hash_uniform(8, 3 * k + 1), 2.0 * hash_uniform(8, 3 * k + 2)};
        std::vector<double> all;
        for (const Vec3& p : points)
        {
            all.push_back(squared_norm(p - place));
        }
        std::sort(all.begin(), all.end());
        const auto nearest = tree.nearest_squared<5>(place);
        EXPECT_TRUE(std::equal(nearest.begin(), nearest.end(), all.begin()));
    }
    const auto alone = PointTree(std::vector<Vec3>{{1, 0, 0}}).nearest_squared<2>({1, 0, 2});
    EXPECT_EQ(alone[0], 4.0);
    EXPECT_TRUE(std::isinf(alone[1]));
}

} // namespace
} // namespace corticle
