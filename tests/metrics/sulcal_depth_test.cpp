// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/sulcal_depth.hpp"

#include "corticle/geometry/hull.hpp"
#include "metrics/turned_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace corticle
{
namespace
{

using std::numbers::pi;
using test::ProfilePoint;

std::vector<double> depth_below_hull(const TriangleMesh& mesh)
{
    const TriangleMesh hull = geometry::convex_hull(mesh.vertices);
    return metrics::sulcal_depth(mesh.vertices, mesh.triangles, geometry::SurfaceTree(hull.vertices, hull.triangles));
}

double turn(const ProfilePoint& o, const ProfilePoint& a, const ProfilePoint& b)
{
    return (a.r - o.r) * (b.z - o.z) - (a.z - o.z) * (b.r - o.r);
}

double distance_to_chord(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b)
{
    const double length = std::hypot(b.r - a.r, b.z - a.z);
    const double s = std::clamp(((p.r - a.r) * (b.r - a.r) + (p.z - a.z) * (b.z - a.z)) / (length * length), 0.0, 1.0);
    return std::hypot(p.r - a.r - s * (b.r - a.r), p.z - a.z - s * (b.z - a.z));
}

/// A sphere with waves from pole to pole: radius R + a cos(degree polar angle).
struct WavySphere
{
    double R = 10.0;
    double a = 0.8;
    double degree = 12.0;
    std::vector<ProfilePoint> hull; ///< convex hull of the meridian, from the upper to the lower pole

    WavySphere()
    {
        constexpr int samples = 40000;
        for (int k = 0; k <= samples; ++k)
        {
            const ProfilePoint p = at(pi * k / samples);
            while (hull.size() >= 2 && turn(hull[hull.size() - 2], hull.back(), p) >= 0.0)
            {
                hull.pop_back();
            }
            hull.push_back(p);
        }
    }
    double radius(double polar) const { return R + a * std::cos(degree * polar); }
    ProfilePoint at(double polar) const { return {radius(polar) * std::sin(polar), radius(polar) * std::cos(polar)}; }
    /// Exact: the body is one of revolution, so the way to the hull stays in the meridian.
    double depth(const Vec3& x) const
    {
        const ProfilePoint p{std::hypot(x.x, x.y), x.z};
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k < hull.size(); ++k)
        {
            nearest = std::min(nearest, distance_to_chord(p, hull[k - 1], hull[k]));
        }
        return nearest;
    }
};

TEST(SulcalDepth, OfAWavySphere)
{
    const WavySphere exact;
    const TriangleMesh mesh = test::star([&](const Vec3& n) { return exact.radius(std::acos(n.z)); });
    const std::vector<double> depth = depth_below_hull(mesh);
    const std::vector<double> areas = vertex_areas(mesh.vertices, mesh.triangles);
    double right_sum = 0.0;
    double off_sum = 0.0;
    double deepest = 0.0;
    double largest_off = 0.0;
    for (std::size_t v = 0; v < depth.size(); ++v)
    {
        const double right = exact.depth(mesh.vertices[v]);
        right_sum += areas[v] * right;
        off_sum += areas[v] * std::abs(depth[v] - right);
        deepest = std::max(deepest, right);
        largest_off = std::max(largest_off, std::abs(depth[v] - right));
    }
    fmt::print("wavy sphere, {:.3f} mm deep: depth off by {:.2f} % of it at most, mean off by {:.2f} %\n", deepest,
               100.0 * largest_off / deepest, 100.0 * off_sum / right_sum);
    EXPECT_GT(deepest, 1.0);
    EXPECT_LT(largest_off, 0.03 * deepest);
    EXPECT_LT(off_sum, 0.03 * right_sum);
    EXPECT_NEAR(*std::max_element(depth.begin(), depth.end()) / deepest, 1.0, 0.01);
}

TEST(SulcalDepth, OfAConvexBodyIsZero)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({9, 7, 5}, 0.6);
    for (const double d : depth_below_hull(mesh))
    {
        EXPECT_NEAR(d, 0.0, 1e-6);
    }
}

TEST(SulcalDepth, GoesRoundTheCornerOfABentGroove)
{
    // A cylinder of radius 10 with a groove at 0 < z < 1, in to r = 6, that opens upward below the wall: 6 < r < 7,
    // 1 < z < 4.
    const double step = 0.12;
    const auto profile =
        test::along({{step, -8}, {10, -8}, {10, 0}, {6, 0}, {6, 4}, {7, 4}, {7, 1}, {10, 1}, {10, 8}, {0, 8}}, step);
    const TriangleMesh mesh = test::turned(profile, -8, 8, 400);
    const std::vector<double> depth = depth_below_hull(mesh);
    const auto depth_at = [&](const Vec3& x)
    {
        std::size_t nearest = 0;
        for (std::size_t v = 0; v < depth.size(); ++v)
        {
            nearest = squared_norm(mesh.vertices[v] - x) < squared_norm(mesh.vertices[nearest] - x) ? v : nearest;
        }
        return depth[nearest];
    };
    // Round the corner at r = 7, z = 1, three below the wall.
    EXPECT_NEAR(depth_at({7, 0, 2.5}) / (3.0 + 1.5), 1.0, 0.03);
    EXPECT_NEAR(depth_at({7, 0, 4}) / (3.0 + 3.0), 1.0, 0.03);
    // On the floor of the groove the way is straight.
    EXPECT_NEAR(depth_at({6, 0, 0.5}), 4.0, 0.01);
    EXPECT_NEAR(depth_at({8, 0, 0}), 2.0, 0.5 * step + 0.01); // at the vertex nearest to that place
    // The far bank of the pocket is reached along the surface, which is at most a groove's width longer than free
    // space.
    const double free_way = 3.0 + std::hypot(1.0, 3.0);
    EXPECT_GT(depth_at({6, 0, 4}), free_way * 0.98);
    EXPECT_LT(depth_at({6, 0, 4}), free_way + 1.0);
}

TEST(MarchedDistance, OnASphereIsTheArc)
{
    const double R = 10.0;
    const TriangleMesh mesh = test::sphere(R);
    std::vector<double> start(mesh.vertices.size(), std::numeric_limits<double>::infinity());
    start[7] = 0.0;
    const std::vector<double> distance = metrics::marched_distance(mesh.vertices, mesh.triangles, start);
    for (std::size_t v = 0; v < distance.size(); ++v)
    {
        const double arc =
            R * std::acos(std::clamp(dot(normalized(mesh.vertices[v]), normalized(mesh.vertices[7])), -1.0, 1.0));
        EXPECT_NEAR(distance[v], arc, 0.03 * arc + 0.1); // first order, and a point as source
    }
}

} // namespace
} // namespace corticle
