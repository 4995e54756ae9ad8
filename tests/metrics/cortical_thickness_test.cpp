// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/cortical_thickness.hpp"

#include "corticle/metrics/asymmetry.hpp"
#include "geometry/simple_surfaces.hpp"
#include "metrics/turned_surfaces.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

TEST(CorticalThickness, OfAShellIsTheDifferenceOfTheRadii)
{
    const TriangleMesh outer = test::sphere(10);
    std::vector<Vec3> inner = outer.vertices;
    for (Vec3& v : inner)
    {
        v *= 0.8;
    }
    for (const double t : metrics::cortical_thickness(outer.vertices, inner, outer.triangles))
    {
        EXPECT_NEAR(t, 2.0, 0.01); // chords sag by edge² / (8 R) = 0.002 mm
    }
}

TEST(CarriedPoints, FollowAnAffineMotionExactly)
{
    std::vector<Vec3> reference;
    for (int k = 0; k < 1000; ++k)
    {
        reference.push_back({k % 10 + 0.1 * std::sin(k), k / 10 % 10 + 0.1 * std::cos(k), k / 100 + 0.05 * (k % 7)});
    }
    Mat3 A = Mat3::identity();
    A(0, 1) = 0.7;
    A(1, 1) = 1.4;
    A(2, 0) = -0.3;
    const Vec3 shift{3, -2, 1};
    std::vector<Vec3> current;
    for (const Vec3& X : reference)
    {
        current.push_back(A * X + shift);
    }
    const std::vector<Mat3> F(reference.size(), A);
    const std::vector<Vec3> points{{4.3, 5.1, 6.7}, {0, 0, 0}, {9.2, 1, 3}, {-40, 0, 0}}; // the last beyond all support
    const std::vector<Vec3> carried = metrics::carried_points({reference, current, F, 1.0}, points);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        EXPECT_NEAR(norm(carried[k] - (A * points[k] + shift)), 0.0, 1e-12);
    }
}

TEST(Asymmetry, OfAMirroredBodyIsZero)
{
    TriangleMesh left = geometry::make_ellipsoid({4, 7, 5}, 0.6);
    TriangleMesh right = left;
    for (std::size_t v = 0; v < left.vertices.size(); ++v)
    {
        left.vertices[v].x -= 3.0; // the halves interlock: both cross the plane
        right.vertices[v].x = -left.vertices[v].x;
    }
    for (Triangle& t : right.triangles)
    {
        std::swap(t[1], t[2]);
    }
    const TriangleMesh both = test::together(left, right);
    const metrics::Asymmetry sides =
        metrics::asymmetry(both.vertices, both.triangles, metrics::mid_sagittal_plane(both.vertices));
    EXPECT_NEAR(sides.area, 0.0, 1e-12);
    EXPECT_NEAR(sides.volume, 0.0, 1e-12);
}

TEST(Asymmetry, OfABoxCutAtAQuarter)
{
    const TriangleMesh box = test::box({-1, 0, 0}, {3, 1, 1});
    const metrics::Asymmetry sides = metrics::asymmetry(box.vertices, box.triangles, {{0, 0, 0}, {1, 0, 0}});
    EXPECT_NEAR(sides.volume, 2.0 * (1.0 - 3.0) / 4.0, 1e-14);
    EXPECT_NEAR(sides.area, 2.0 * (5.0 - 13.0) / 18.0, 1e-14);
    const metrics::Asymmetry other = metrics::asymmetry(box.vertices, box.triangles, {{0, 0, 0}, {-2, 0, 0}});
    EXPECT_NEAR(other.volume, -sides.volume, 1e-14);
    const metrics::Asymmetry middle =
        metrics::asymmetry(box.vertices, box.triangles, metrics::mid_sagittal_plane(box.vertices));
    EXPECT_NEAR(middle.volume, 0.0, 1e-14);
    EXPECT_NEAR(middle.area, 0.0, 1e-14);
}

} // namespace
} // namespace corticle
