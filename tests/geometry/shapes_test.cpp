// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/shapes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/geometry/validate.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace corticle
{
namespace
{

TEST(Ellipsoid, IsAValidSurfaceOfExactVolume)
{
    for (const std::array<double, 3>& a :
         {std::array{1.0, 1.0, 1.0}, std::array{1.0, 2.0, 3.0}, std::array{4.0, 4.0, 1.0}})
    {
        const TriangleMesh mesh = geometry::make_ellipsoid(a, 0.2);
        EXPECT_NO_THROW(geometry::require_valid_surface(mesh, "ellipsoid"));
        const double volume = 4.0 / 3.0 * std::numbers::pi * a[0] * a[1] * a[2];
        EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles) / volume, 1.0, 1e-12);
    }
}

TEST(Ellipsoid, HasEvenEdgesOfTheGivenLength)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({1.0, 1.2, 1.5}, 0.1);
    std::vector<double> edges;
    for (const Triangle& t : mesh.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            edges.push_back(norm(mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]) / 0.1);
        }
    }
    std::sort(edges.begin(), edges.end());
    EXPECT_GT(edges.front(), 0.7);
    EXPECT_LT(edges.back(), 1.7);
    EXPECT_NEAR(edges[edges.size() / 2], 1.0, 0.05);
}

TEST(Ellipsoid, IsTheSameForAnyNumberOfThreads)
{
    const int threads = thread_count();
    set_thread_count(1);
    const TriangleMesh one = geometry::make_ellipsoid({1.0, 1.2, 1.5}, 0.1);
    set_thread_count(2);
    const TriangleMesh two = geometry::make_ellipsoid({1.0, 1.2, 1.5}, 0.1);
    set_thread_count(threads);
    EXPECT_EQ(one.vertices, two.vertices);
    EXPECT_EQ(one.triangles, two.triangles);
}

TEST(Ellipsoid, RefusesNonsense)
{
    EXPECT_THROW(geometry::make_ellipsoid({1.0, 1.0, 0.0}, 0.1), InputError);
    EXPECT_THROW(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.0), InputError);
    EXPECT_THROW(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 5.0), InputError);
    EXPECT_THROW(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 1e-6), InputError);
}

TEST(ConvexHull, OfACubeWithPointsInside)
{
    TriangleMesh box = test::box({0, 0, 0}, {2, 2, 2});
    box.vertices.push_back({1, 1, 1});
    box.vertices.push_back({1, 1, 2});
    const TriangleMesh hull = geometry::convex_hull(box.vertices);
    EXPECT_NEAR(enclosed_volume(hull.vertices, hull.triangles), 8.0, 1e-12);
    EXPECT_NEAR(surface_area(hull.vertices, hull.triangles), 24.0, 1e-12);
}

TEST(ConvexHull, RefusesFlatPoints)
{
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 4, 0}};
    EXPECT_THROW(geometry::convex_hull(flat), InputError);
    EXPECT_THROW(geometry::convex_hull(std::vector<Vec3>(6, Vec3{1, 2, 3})), InputError);
    EXPECT_THROW(geometry::convex_hull({}), InputError);
}

} // namespace
} // namespace corticle
