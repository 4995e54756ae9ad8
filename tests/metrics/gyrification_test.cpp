// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/metrics/surface/local_gyrification.hpp"
#include "corticle/metrics/surface/zilles.hpp"
#include "metrics/turned_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{
namespace
{

using std::numbers::pi;

/// A cylinder along z whose wall is a sine: r = R + a sin(waves angle).
struct SineCylinder
{
    double R = 10.0;
    double a = 1.0;
    int waves = 12;

    double radius(double angle) const { return R + a * std::sin(waves * angle); }

    TriangleMesh mesh(int sectors) const
    {
        TriangleMesh m = test::turned({{R, -10}, {R, -4}, {R, 5}, {R, 10}}, -10, 10, sectors);
        for (Vec3& v : m.vertices)
        {
            const double scale = radius(std::atan2(v.y, v.x)) / R;
            v = {scale * v.x, scale * v.y, v.z};
        }
        return m;
    }

    /// Length of the wall by Simpson's rule, to 1e-10.
    double whole_contour() const
    {
        constexpr int pieces = 20000;
        double sum = 0.0;
        for (int k = 0; k < pieces; ++k)
        {
            const double angle =
                2.0 * pi * k / pieces; // periodic: the trapezoidal rule converges faster than any power
            sum += std::hypot(radius(angle), a * waves * std::cos(waves * angle));
        }
        return 2.0 * pi / pieces * sum;
    }

    /// Of each wave the hull keeps the arc about the crest, between the angles where the tangent is that of the chord,
    /// which by symmetry crosses the middle of the trough at right angles: n . (cos m, sin m) is stationary there.
    double outer_contour() const
    {
        const double trough = 1.5 * pi / waves; // angle of a trough; the crests are pi / waves away
        // The chord's height p = r cos(angle - trough) is largest over the wave where the hull leaves it.
        const auto slope = [&](double away)
        {
            const double angle = trough + away;
            return a * waves * std::cos(waves * angle) * std::cos(away) - radius(angle) * std::sin(away);
        };
        double low = 0.5 * pi / waves; // steepest: the height still grows
        double high = pi / waves;      // crest: it falls
        for (int k = 0; k < 60; ++k)
        {
            const double middle = 0.5 * (low + high);
            (slope(middle) > 0.0 ? low : high) = middle;
        }
        const double chord = 2.0 * radius(trough + low) * std::sin(low);
        constexpr int pieces = 20000;
        const double width = (2.0 * pi / waves - 2.0 * low) / pieces;
        double arc = 0.0;
        for (int k = 0; k < pieces; ++k)
        {
            const double angle = trough + low + (k + 0.5) * width;
            arc += width * std::hypot(radius(angle), a * waves * std::cos(waves * angle));
        }
        return waves * (chord + arc);
    }
};

TEST(ZillesIndex, OfACylinderWithSineWalls)
{
    const SineCylinder body;
    const TriangleMesh mesh = body.mesh(2400);
    const metrics::SliceGyrification slices =
        metrics::zilles_index(mesh.vertices, mesh.triangles, {.normal = {0, 0, 1}, .count = 23});
    const double exact = body.whole_contour() / body.outer_contour();
    fmt::print("sine cylinder: index {:.6f}, exact {:.6f}\n", slices.index, exact);
    EXPECT_GT(exact, 1.15);
    EXPECT_NEAR(slices.index / exact, 1.0, 1e-4); // 200 chords a wave
    EXPECT_NEAR(slices.mean_of_slices / slices.index, 1.0, 1e-12);
    EXPECT_EQ(slices.slices, 23);
}

TEST(ZillesIndex, IsOneForAConvexBodyAndAnyDirection)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({9, 7, 5}, 0.6);
    for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, -2, 3}})
    {
        EXPECT_NEAR(metrics::zilles_index(mesh.vertices, mesh.triangles, {.normal = normal}).index, 1.0,
                    1e-4); // the triangles are not quite those of the hull
    }
}

TEST(ZillesIndex, RefusesSlicesThatAreNone)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({9, 7, 5}, 2.0);
    EXPECT_THROW(metrics::zilles_index(mesh.vertices, mesh.triangles, {.count = 0}), InputError);
    EXPECT_THROW(metrics::zilles_index(mesh.vertices, mesh.triangles, {.normal = {0, 0, 0}}), InputError);
}

std::vector<double> local_index(const TriangleMesh& mesh, double radius)
{
    const TriangleMesh hull = geometry::convex_hull(mesh.vertices);
    return metrics::local_gyrification(mesh.vertices, mesh.triangles,
                                       geometry::SurfaceTree(hull.vertices, hull.triangles), radius);
}

TEST(LocalGyrification, OfASphereIsOne)
{
    const TriangleMesh mesh = test::sphere(10);
    const std::vector<double> index = local_index(mesh, 3.7);
    const auto [low, high] = std::minmax_element(index.begin(), index.end());
    fmt::print("sphere: local index {:.4f} to {:.4f}\n", *low, *high);
    EXPECT_GT(*low, 0.99);
    EXPECT_LT(*high, 1.01);
}

TEST(LocalGyrification, RisesOnlyWhereThereAreFolds)
{
    const auto waves = [](const Vec3& n)
    { return n.z > 0.0 ? 0.5 * n.z * n.z * (std::cos(24.0 * std::acos(n.z)) - 1.0) : 0.0; };
    const TriangleMesh mesh = test::star([&](const Vec3& n) { return 10.0 + waves(n); });
    const std::vector<double> index = local_index(mesh, 3.0);
    for (std::size_t v = 0; v < index.size(); ++v)
    {
        const double z = mesh.vertices[v].z;
        if (z < -3.5)
        {
            EXPECT_NEAR(index[v], 1.0, 0.01);
        }
        else if (z > 9.0)
        {
            EXPECT_GT(index[v], 1.1); // waves of slope 1 lengthen the meridian by 1.2
        }
    }
    EXPECT_THROW(local_index(mesh, 0.0), InputError);
}

TEST(LocalGyrification, HasTheMeanOfTheWholeBodyHoweverDeepTheFolds)
{
    // Folds two ball radii deep.
    const TriangleMesh mesh = test::star([](const Vec3& n) { return 8.5 + 1.5 * std::cos(12.0 * std::acos(n.z)); });
    const std::vector<double> index = local_index(mesh, 1.5);
    const TriangleMesh hull = geometry::convex_hull(mesh.vertices);
    const double whole = surface_area(mesh.vertices, mesh.triangles) / surface_area(hull.vertices, hull.triangles);
    double sum = 0.0; // harmonic, for places on the outer surface count by its area
    const std::vector<double> areas = vertex_areas(mesh.vertices, mesh.triangles);
    for (std::size_t v = 0; v < index.size(); ++v)
    {
        sum += areas[v] / index[v];
    }
    EXPECT_GT(whole, 1.25);
    EXPECT_NEAR(surface_area(mesh.vertices, mesh.triangles) / sum / whole, 1.0, 0.03);
}

} // namespace
} // namespace corticle
