// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/neighbors.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/geometry/shapes.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{
namespace
{

bool are_neighbors(const Neighbors& pairs, std::int64_t i, std::int64_t j)
{
    return std::binary_search(pairs.index.begin() + pairs.begin[i], pairs.index.begin() + pairs.begin[i + 1], j);
}

std::vector<Vec3> random_points(std::uint64_t count)
{
    std::vector<Vec3> points;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        points.push_back({hash_uniform(3, 3 * k), 2.0 * hash_uniform(3, 3 * k + 1), 0.5 * hash_uniform(3, 3 * k + 2)});
    }
    return points;
}

TEST(Neighbors, AreAllPairsWithinTheSupport)
{
    const std::vector<Vec3> points = random_points(600);
    const double support = 0.17;
    const Neighbors pairs = cloud::find_pairs_within(points, support);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        std::vector<std::int32_t> expected;
        for (std::size_t j = 0; j < points.size(); ++j)
        {
            if (j != i && squared_norm(points[j] - points[i]) < support * support)
            {
                expected.push_back(static_cast<std::int32_t>(j));
            }
        }
        const std::vector<std::int32_t> found(pairs.index.begin() + pairs.begin[i],
                                              pairs.index.begin() + pairs.begin[i + 1]);
        EXPECT_EQ(found, expected);
    }
}

TEST(Neighbors, OfNothingAndOfOne)
{
    EXPECT_EQ(cloud::find_pairs_within({}, 1.0).begin.size(), 1u);
    EXPECT_TRUE(cloud::find_pairs_within(std::vector<Vec3>{{1, 2, 3}}, 1.0).index.empty());
    EXPECT_THROW(cloud::find_pairs_within({}, 0.0), InputError);
}

TEST(Neighbors, OnAnEllipsoidAllSeeEachOther)
{
    const TriangleMesh surface = geometry::make_ellipsoid({5.0, 6.0, 7.0}, 0.8);
    const Cloud cloud = cloud::fill_surface(surface, {0.78, 1});
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    cloud::VisibilityReport report;
    const Neighbors seen = cloud::find_neighbors(cloud, tree, 2.5 * cloud.spacing, &report);
    EXPECT_EQ(report.dropped_pairs, 0);
    EXPECT_EQ(seen.index, cloud::find_pairs_within(cloud.positions, 2.5 * cloud.spacing).index);
}

/// A point of a ball whose inside is hollowed by another: chords over the hollow graze a concave surface.
TEST(Neighbors, OverAGentlyConcaveSurfaceAllSeeEachOther)
{
    const TriangleMesh outer = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 1.0);
    TriangleMesh inner = geometry::make_ellipsoid({5.0, 5.0, 5.0}, 1.0);
    for (Triangle& t : inner.triangles)
    {
        std::swap(t[0], t[1]);
    }
    const TriangleMesh shell = test::together(outer, inner);
    const Cloud cloud = cloud::fill_surface(shell, {1.0, 1});
    const geometry::SurfaceTree tree(shell.vertices, shell.triangles);
    cloud::VisibilityReport report;
    cloud::find_neighbors(cloud, tree, 2.5 * cloud.spacing, &report);
    EXPECT_EQ(report.dropped_pairs, 0);
}

TEST(Neighbors, AcrossANarrowFissureNobodySees)
{
    // Two blocks 0.3 apart; their own particles on and in them at spacing 1.
    const TriangleMesh blocks = test::together(test::box({0, 0, 0}, {4, 6, 6}), test::box({4.3, 0, 0}, {8.3, 6, 6}));
    Cloud cloud;
    cloud.spacing = 1.0;
    for (int block = 0; block < 2; ++block)
    {
        for (int k = 0; k < 125; ++k)
        {
            cloud.positions.push_back({4.3 * block + k / 25, 1.0 + k / 5 % 5 * 1.01, 1.0 + k % 5 * 1.02});
        }
    }
    const geometry::SurfaceTree tree(blocks.vertices, blocks.triangles);
    cloud::VisibilityReport report;
    const Neighbors seen = cloud::find_neighbors(cloud, tree, 2.5, &report);
    const Neighbors all = cloud::find_pairs_within(cloud.positions, 2.5);
    std::int64_t across = 0;
    for (std::int64_t i = 0; i < 250; ++i)
    {
        for (std::int64_t k = all.begin[i]; k < all.begin[i + 1]; ++k)
        {
            const std::int64_t j = all.index[k];
            const bool same_block = (i < 125) == (j < 125);
            EXPECT_EQ(are_neighbors(seen, i, j), same_block);
            across += same_block ? 0 : 1;
        }
    }
    EXPECT_GT(across, 0);
    EXPECT_EQ(report.dropped_pairs, across / 2);
}

TEST(Neighbors, AreSymmetricAndTheSameForAnyNumberOfThreads)
{
    const TriangleMesh surface = geometry::make_ellipsoid({3.0, 3.0, 6.0}, 0.8);
    const Cloud cloud = cloud::fill_surface(surface, {0.8, 1});
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    const int threads = thread_count();
    set_thread_count(1);
    const Neighbors one = cloud::find_neighbors(cloud, tree, 2.0);
    set_thread_count(2);
    const Neighbors two = cloud::find_neighbors(cloud, tree, 2.0);
    set_thread_count(threads);
    EXPECT_EQ(one.begin, two.begin);
    EXPECT_EQ(one.index, two.index);
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
        for (std::int64_t k = one.begin[i]; k < one.begin[i + 1]; ++k)
        {
            EXPECT_TRUE(are_neighbors(one, one.index[k], static_cast<std::int64_t>(i)));
        }
    }
}

} // namespace
} // namespace corticle
