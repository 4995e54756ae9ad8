// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/sulcal_pits.hpp"

#include "corticle/geometry/hull.hpp"
#include "corticle/metrics/surface/sulcal_depth.hpp"
#include "metrics/turned_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{
namespace
{

/// Directions of the corners of an icosahedron.
std::vector<Vec3> icosahedron()
{
    std::vector<Vec3> corners;
    for (const double a : {1.0, -1.0})
    {
        for (const double b : {std::numbers::phi, -std::numbers::phi})
        {
            corners.insert(corners.end(), {normalized({0, a, b}), normalized({a, b, 0}), normalized({b, 0, a})});
        }
    }
    return corners;
}

metrics::DepthExtrema extrema_of(const TriangleMesh& mesh, double ridge_height)
{
    const TriangleMesh hull = geometry::convex_hull(mesh.vertices);
    const auto depth =
        metrics::sulcal_depth(mesh.vertices, mesh.triangles, geometry::SurfaceTree(hull.vertices, hull.triangles));
    return metrics::depth_extrema(depth, mesh.triangles, ridge_height);
}

TEST(SulcalPits, OfASphereWithTwelveHollows)
{
    const std::vector<Vec3> places = icosahedron();
    const TriangleMesh mesh = test::star(
        [&](const Vec3& n)
        {
            double radius = 10.0;
            for (const Vec3& place : places)
            {
                radius -= 1.5 * std::exp((dot(n, place) - 1.0) / 0.02); // about 0.14 rad wide
            }
            return radius;
        });
    const metrics::DepthExtrema found = extrema_of(mesh, 0.3);
    ASSERT_EQ(found.pits.size(), 12u);
    EXPECT_EQ(found.crowns.size(), 1u); // the land between the hollows is one
    for (const Vec3& place : places)
    {
        const auto is_there = [&](std::int32_t v) { return norm(normalized(mesh.vertices[v]) - place) < 0.05; };
        EXPECT_EQ(std::count_if(found.pits.begin(), found.pits.end(), is_there), 1);
    }
}

TEST(GyralCrowns, OfASphereWithThreeGroovesAround)
{
    const TriangleMesh mesh = test::star(
        [](const Vec3& n)
        {
            double radius = 10.0;
            for (const double z : {-0.4, 0.0, 0.5})
            {
                radius -= 1.5 * std::exp(-std::pow((n.z - z) / 0.08, 2));
            }
            return radius;
        });
    EXPECT_EQ(extrema_of(mesh, 0.3).crowns.size(), 4u);
}

TEST(SulcalPits, ASmoothSphereHasNone)
{
    const metrics::DepthExtrema found = extrema_of(test::sphere(10), 0.1);
    EXPECT_TRUE(found.pits.empty());
    EXPECT_TRUE(found.crowns.empty());
}

TEST(ProminentMaxima, MergeAcrossLowRidges)
{
    const TriangleMesh mesh = test::sphere(10);
    std::vector<double> values;
    for (const Vec3& v : mesh.vertices)
    {
        const Vec3 n = normalized(v);
        values.push_back(n.x > 0.0 ? n.x * n.x : 0.5 * n.x * n.x); // heights 1 and 0.5 above a valley of height 0
    }
    EXPECT_EQ(metrics::prominent_maxima(values, mesh.triangles, 0.4).size(), 2u);
    const auto one = metrics::prominent_maxima(values, mesh.triangles, 0.6);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_GT(mesh.vertices[one[0]].x, 9.5);
    EXPECT_TRUE(metrics::prominent_maxima(values, mesh.triangles, 1.1).empty());
}

} // namespace
} // namespace corticle
