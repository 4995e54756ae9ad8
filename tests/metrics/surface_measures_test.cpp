// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface_measures.hpp"

#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace corticle
{
namespace
{

using std::numbers::pi;

TriangleMesh ball(double radius, double edge, const Vec3& centre)
{
    TriangleMesh mesh = geometry::make_ellipsoid({radius, radius, radius}, edge);
    for (Vec3& v : mesh.vertices)
    {
        v += centre;
    }
    return mesh;
}

TEST(SurfaceMeasures, SphereOfTheThesis)
{
    const TriangleMesh mesh = ball(12.496, 0.6, {1, 2, 3});
    const metrics::SurfaceMeasures m = metrics::measure_surface(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(m.volume_mm3, 8173.38, 0.01); // the shape keeps the volume exactly
    // Flat triangles of edge h on a sphere lose about h² / (8 R²) of the area, given the volume: 0.03 %.
    EXPECT_NEAR(m.area_mm2 / 1962.24, 1.0, 1e-3);
    EXPECT_NEAR(m.gi_sphere, 1.0, 1e-3);
    EXPECT_GE(m.gi_sphere, 1.0); // the isoperimetric inequality
    EXPECT_NEAR(m.gi_hull, 1.0, 1e-3);
    EXPECT_DOUBLE_EQ(m.area_per_volume, m.area_mm2 / m.volume_mm3);
}

TEST(SurfaceMeasures, ProlateSpheroid)
{
    const double a = 6.0;
    const double c = 10.0;
    const double e = std::sqrt(1.0 - a * a / (c * c));
    const double area = 2.0 * pi * a * a * (1.0 + c / (a * e) * std::asin(e));
    const TriangleMesh mesh = geometry::make_ellipsoid({a, a, c}, 0.5);
    const metrics::SurfaceMeasures m = metrics::measure_surface(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(m.area_mm2 / area, 1.0, 2e-3); // h² / (8 R²) with the smallest radius of curvature, 3.6
    EXPECT_NEAR(m.volume_mm3 / (4.0 / 3.0 * pi * a * a * c), 1.0, 1e-12);
    EXPECT_NEAR(m.gi_hull, 1.0, 1e-3);
}

TEST(SurfaceMeasures, BoxesExactly)
{
    const TriangleMesh one = test::box({0, 0, 0}, {1, 1, 1});
    const metrics::SurfaceMeasures cube = metrics::measure_surface(one.vertices, one.triangles);
    EXPECT_DOUBLE_EQ(cube.area_mm2, 6.0);
    EXPECT_DOUBLE_EQ(cube.volume_mm3, 1.0);
    EXPECT_DOUBLE_EQ(cube.gi_hull, 1.0);
    EXPECT_NEAR(cube.gi_sphere, 6.0 / std::cbrt(36.0 * pi), 1e-14);
    // Two cubes one edge apart: 12 over the 14 of the box around them.
    const TriangleMesh two = test::together(one, test::box({2, 0, 0}, {3, 1, 1}));
    EXPECT_NEAR(metrics::measure_surface(two.vertices, two.triangles).gi_hull, 12.0 / 14.0, 1e-14);
}

TEST(SurfaceMeasures, SphereIndexOfASphereIsOneAtAnySize)
{
    for (const double r : {0.01, 1.0, 300.0})
    {
        EXPECT_NEAR(sphere_index(4.0 * pi * r * r, 4.0 / 3.0 * pi * r * r * r), 1.0, 1e-14);
    }
}

TEST(Overlap, IsZeroForAConvexBody)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({10, 7, 5}, 1.0);
    const metrics::Overlap overlap = metrics::measure_overlap(mesh.vertices, mesh.triangles, 0.01);
    EXPECT_EQ(overlap.area_share, 0.0);
    EXPECT_EQ(overlap.deepest_penetration, 0.0);
}

struct CrossedSpheres
{
    // Radius 10, centres 12 apart: each loses a cap of height 10 - 6 = 4.
    TriangleMesh mesh = test::together(ball(10, 1.0, {}), ball(10, 1.0, {12, 0, 0}));
};

TEST(Overlap, IsTheShareOfTheCapsOfTwoCrossedSpheres)
{
    const CrossedSpheres spheres;
    const metrics::Overlap overlap = metrics::measure_overlap(spheres.mesh.vertices, spheres.mesh.triangles, 0.01);
    // Area of a cap 2 pi R h over 4 pi R²: h / (2 R) = 0.2. Triangles on the rim count whole: well under 2 %.
    EXPECT_NEAR(overlap.area_share / 0.2, 1.0, 0.02);
}

TEST(Overlap, DeepestPenetrationOfTwoCrossedSpheres)
{
    const CrossedSpheres spheres;
    const metrics::Overlap overlap = metrics::measure_overlap(spheres.mesh.vertices, spheres.mesh.triangles, 0.01);
    // The pole of each cap lies 8 from the other sphere's surface, within the sag of a triangle and half an edge.
    EXPECT_NEAR(overlap.deepest_penetration, 8.0, 0.2);
}

TEST(Winding, CountsTheBodiesAroundAPoint)
{
    const CrossedSpheres spheres;
    const geometry::SurfaceTree tree(spheres.mesh.vertices, spheres.mesh.triangles);
    EXPECT_EQ(tree.winding_number({6, 0.1, 0.2}), 2);
    EXPECT_EQ(tree.winding_number({-5, 1, 0}), 1);
    EXPECT_EQ(tree.winding_number({17, 1, 0}), 1);
    EXPECT_EQ(tree.winding_number({6, 9, 0}), 0);
    EXPECT_EQ(tree.winding_number({40, 0, 0}), 0);
}

} // namespace
} // namespace corticle
