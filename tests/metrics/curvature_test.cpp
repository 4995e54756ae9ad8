// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/curvature.hpp"

#include "corticle/metrics/surface_measures.hpp"
#include "metrics/turned_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{
namespace
{

using std::numbers::pi;

struct Error
{
    double mean = 0.0; ///< |value - exact| / |exact|, weighted with area
    double largest = 0.0;
};

template <class Exact>
Error error(const TriangleMesh& mesh, std::span<const double> values, Exact&& exact)
{
    const std::vector<double> areas = vertex_areas(mesh.vertices, mesh.triangles);
    Error e;
    double total = 0.0;
    for (std::size_t v = 0; v < values.size(); ++v)
    {
        const double right = exact(mesh.vertices[v]);
        const double off = std::abs(values[v] - right) / std::abs(right);
        e.mean += areas[v] * off;
        total += areas[v];
        e.largest = std::max(e.largest, off);
    }
    e.mean /= total;
    return e;
}

TEST(Curvature, OfASphere)
{
    const double R = 10.0;
    const TriangleMesh mesh = test::sphere(R);
    ASSERT_NEAR(static_cast<double>(mesh.vertices.size()), 1e4, 500.0);
    const metrics::Curvature c = metrics::vertex_curvature(mesh.vertices, mesh.triangles);
    const Error H = error(mesh, c.mean, [&](const Vec3&) { return 1.0 / R; });
    const Error K = error(mesh, c.gaussian, [&](const Vec3&) { return 1.0 / (R * R); });
    fmt::print("sphere, {} vertices: H off by {:.3f} % (mean), {:.2f} % (largest); K {:.3f} %, {:.2f} %\n",
               mesh.vertices.size(), 100.0 * H.mean, 100.0 * H.largest, 100.0 * K.mean, 100.0 * K.largest);
    EXPECT_LT(H.mean, 0.002);
    EXPECT_LT(H.largest, 0.01);
    EXPECT_LT(K.mean, 0.004);
    EXPECT_LT(K.largest, 0.02);
    EXPECT_GT(*std::min_element(c.shape_index.begin(), c.shape_index.end()), 0.9); // caps
    EXPECT_LT(error(mesh, c.curvedness, [&](const Vec3&) { return 1.0 / R; }).mean, 0.002);
    const metrics::SurfaceMeasures m = metrics::measure_surface(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(m.area_mm2 / (4.0 * pi * R * R), 1.0, 0.001);
    EXPECT_NEAR(m.volume_mm3 / (4.0 / 3.0 * pi * R * R * R), 1.0, 1e-9);
}

TEST(Curvature, OfAnEllipsoid)
{
    const Vec3 axes{12, 9, 7};
    const double p = 1.6075; // Thomsen's formula: the area to 1.1 % at worst, enough for the edge length
    const auto power = [&](double a, double b) { return std::pow(a * b, p); };
    const double area =
        4.0 * pi * std::pow((power(axes.x, axes.y) + power(axes.x, axes.z) + power(axes.y, axes.z)) / 3.0, 1.0 / p);
    const TriangleMesh mesh = geometry::make_ellipsoid({axes.x, axes.y, axes.z}, test::edge_for_10000_vertices(area));
    ASSERT_NEAR(static_cast<double>(mesh.vertices.size()), 1e4, 500.0);
    const metrics::Curvature c = metrics::vertex_curvature(mesh.vertices, mesh.triangles);
    const double abc = axes.x * axes.y * axes.z;
    const auto squared_gradient = [&](const Vec3& x) {
        return squared_norm(Vec3{x.x / (axes.x * axes.x), x.y / (axes.y * axes.y), x.z / (axes.z * axes.z)});
    };
    // do Carmo, Differential Geometry, sections 3-3 and 4-3.
    const auto mean = [&](const Vec3& x)
    { return (squared_norm(axes) - squared_norm(x)) / (2.0 * abc * abc * std::pow(squared_gradient(x), 1.5)); };
    const auto gaussian = [&](const Vec3& x) { return 1.0 / (abc * abc * std::pow(squared_gradient(x), 2)); };
    const Error H = error(mesh, c.mean, mean);
    const Error K = error(mesh, c.gaussian, gaussian);
    fmt::print("ellipsoid, {} vertices: H off by {:.3f} % (mean), {:.2f} % (largest); K {:.3f} %, {:.2f} %\n",
               mesh.vertices.size(), 100.0 * H.mean, 100.0 * H.largest, 100.0 * K.mean, 100.0 * K.largest);
    EXPECT_LT(H.mean, 0.005);
    EXPECT_LT(K.mean, 0.01);
}

TEST(Curvature, OfACylinderWallIsARidgeAndOfItsInsideARut)
{
    const double R = 5.0;
    TriangleMesh mesh = test::cylinder(R, 20.0, 0.4);
    const auto on_wall = [&](const Vec3& x) { return std::abs(x.z) < 8.0 && std::hypot(x.x, x.y) > 0.99 * R; };
    for (const double side : {1.0, -1.0})
    {
        const metrics::Curvature c = metrics::vertex_curvature(mesh.vertices, mesh.triangles);
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        {
            if (on_wall(mesh.vertices[v]))
            {
                EXPECT_NEAR(c.mean[v] * 2.0 * R, side, 0.01);
                EXPECT_NEAR(c.gaussian[v] * R * R, 0.0, 0.01);
                EXPECT_NEAR(c.shape_index[v], 0.5 * side, 0.01);
                EXPECT_NEAR(c.curvedness[v] * R * std::numbers::sqrt2, 1.0, 0.01);
            }
        }
        for (Triangle& t : mesh.triangles)
        {
            std::swap(t[1], t[2]);
        }
    }
}

TEST(Curvature, IsFiniteOnACoarseBox)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    for (const double H : metrics::vertex_curvature(mesh.vertices, mesh.triangles).mean)
    {
        EXPECT_TRUE(std::isfinite(H));
        EXPECT_GT(H, 0.0);
    }
}

} // namespace
} // namespace corticle
