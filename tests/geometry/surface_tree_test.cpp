// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/surface_tree.hpp"

#include "corticle/base/random.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/triangle_tests.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace corticle
{
namespace
{

Vec3 random_point(std::uint64_t k, double half_width)
{
    return half_width *
           Vec3{2 * hash_uniform(7, 3 * k) - 1, 2 * hash_uniform(7, 3 * k + 1) - 1, 2 * hash_uniform(7, 3 * k + 2) - 1};
}

TEST(SurfaceTree, ClosestPointAgreesWithAllTriangles)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({1.0, 1.5, 2.0}, 0.3);
    const geometry::SurfaceTree tree(mesh.vertices, mesh.triangles);
    for (std::uint64_t k = 0; k < 300; ++k)
    {
        const Vec3 p = random_point(k, 3.0);
        geometry::SurfacePoint best;
        best.squared_distance = 1e30;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        {
            const geometry::SurfacePoint candidate =
                geometry::closest_point_of_triangle(mesh, static_cast<std::int32_t>(f), p);
            best = candidate.squared_distance < best.squared_distance ? candidate : best;
        }
        const geometry::SurfacePoint found = tree.closest(p);
        EXPECT_EQ(found.triangle, best.triangle);
        EXPECT_EQ(found.squared_distance, best.squared_distance);
        const Triangle& t = mesh.triangles[found.triangle];
        const Vec3 again = found.barycentric[0] * mesh.vertices[t[0]] + found.barycentric[1] * mesh.vertices[t[1]] +
                           found.barycentric[2] * mesh.vertices[t[2]];
        EXPECT_NEAR(norm(again - found.position), 0.0, 1e-12);
    }
}

TEST(SurfaceTree, TiesGoToTheLowestTriangle)
{
    const TriangleMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    const geometry::SurfaceTree tree(box.vertices, box.triangles);
    for (std::size_t v = 0; v < box.vertices.size(); ++v)
    {
        std::int32_t lowest = 0;
        const auto touches = [&](const Triangle& t)
        { return std::find(t.begin(), t.end(), static_cast<std::int32_t>(v)) != t.end(); };
        while (!touches(box.triangles[lowest]))
        {
            ++lowest;
        }
        EXPECT_EQ(tree.closest(2.0 * box.vertices[v]).triangle, lowest);
    }
}

TEST(SurfaceTree, ClosestWithinFindsNothingBeyondItsReach)
{
    const TriangleMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    const geometry::SurfaceTree tree(box.vertices, box.triangles);
    EXPECT_EQ(tree.closest_within({0.1, 0.2, 0.3}, 0.65).triangle, -1);
    EXPECT_GE(tree.closest_within({0.1, 0.2, 0.3}, 0.75).triangle, 0);
}

TEST(SurfaceTree, SignedDistanceAndWindingOfABox)
{
    const TriangleMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    const geometry::SurfaceTree tree(box.vertices, box.triangles);
    for (std::uint64_t k = 0; k < 2000; ++k)
    {
        const Vec3 p = random_point(k, 2.0);
        const Vec3 q{std::abs(p.x) - 1, std::abs(p.y) - 1, std::abs(p.z) - 1};
        const Vec3 outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
        const double expected = norm(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
        EXPECT_NEAR(tree.signed_distance(p), expected, 1e-12);
        EXPECT_EQ(tree.winding_number(p), expected < 0.0 ? 1 : 0);
    }
}

TEST(SurfaceTree, WindingNumberCountsNestedAndTurnedSurfaces)
{
    const TriangleMesh twice = test::together(test::box({-1, -1, -1}, {1, 1, 1}), test::box({-3, -3, -3}, {3, 3, 3}));
    EXPECT_EQ(geometry::SurfaceTree(twice.vertices, twice.triangles).winding_number({0.1, 0.2, 0.3}), 2);
    TriangleMesh turned = test::box({-1, -1, -1}, {1, 1, 1});
    for (Triangle& t : turned.triangles)
    {
        std::swap(t[0], t[1]);
    }
    EXPECT_EQ(geometry::SurfaceTree(turned.vertices, turned.triangles).winding_number({0.1, 0.2, 0.3}), -1);
}

TEST(SurfaceTree, WindingNumberSurvivesARayThroughAVertex)
{
    // Boxes with a corner exactly on the first ray from the origin.
    const Vec3 corner{0.577312893, 0.211324871, 0.788675139};
    const TriangleMesh box = test::box({-1, -1, -1}, corner);
    EXPECT_EQ(geometry::SurfaceTree(box.vertices, box.triangles).winding_number({}), 1);
    const TriangleMesh away = test::box(corner, {2, 2, 2});
    EXPECT_EQ(geometry::SurfaceTree(away.vertices, away.triangles).winding_number({}), 0);
}

TEST(SurfaceTree, NoSegmentSlipsThroughAnEdge)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.3);
    const geometry::SurfaceTree tree(mesh.vertices, mesh.triangles);
    for (const Triangle& t : mesh.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            const Vec3 middle = 0.5 * (mesh.vertices[t[k]] + mesh.vertices[t[(k + 1) % 3]]);
            EXPECT_TRUE(tree.segment_crosses(0.5 * middle, 1.5 * middle));
            EXPECT_TRUE(tree.segment_crosses(0.5 * mesh.vertices[t[k]], 1.5 * mesh.vertices[t[k]]));
            EXPECT_FALSE(tree.segment_crosses(1.1 * middle, 1.5 * middle));
            EXPECT_FALSE(tree.segment_crosses(0.5 * middle, 0.9 * middle));
        }
    }
}

TEST(SurfaceTree, InterpolatedNormalOfASpherePointsOutward)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({2.0, 2.0, 2.0}, 0.2);
    const geometry::SurfaceTree tree(mesh.vertices, mesh.triangles);
    for (std::uint64_t k = 0; k < 200; ++k)
    {
        const Vec3 p = random_point(k, 3.0);
        // Vertex normals of edges of 0.1 radii are off by second order in that.
        EXPECT_GT(dot(tree.interpolated_normal(tree.closest(p)), normalized(p)), 0.995);
    }
}

TEST(SurfaceTree, EmptySurfaceHasNoClosestPoint)
{
    const geometry::SurfaceTree tree({}, {});
    EXPECT_EQ(tree.closest({1, 2, 3}).triangle, -1);
    EXPECT_FALSE(tree.segment_crosses({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(tree.winding_number({0, 0, 0}), 0);
}

} // namespace
} // namespace corticle
