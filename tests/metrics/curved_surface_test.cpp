// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/curved_surface.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "metrics/turned_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using std::numbers::pi;

struct Errors
{
    metrics::CurvedSize curved; ///< over the exact size, less 1
    metrics::CurvedSize flat;
};

Errors errors(const TriangleMesh& mesh, const metrics::CurvedSize& exact)
{
    const metrics::CurvedSize size = metrics::curved_size(mesh.vertices, mesh.triangles);
    return {{size.area_mm2 / exact.area_mm2 - 1.0, size.volume_mm3 / exact.volume_mm3 - 1.0},
            {surface_area(mesh.vertices, mesh.triangles) / exact.area_mm2 - 1.0,
             enclosed_volume(mesh.vertices, mesh.triangles) / exact.volume_mm3 - 1.0}};
}

/// Prints the errors of a body and, beside those of the mesh of twice the edge, the order in which they fall.
void expect_fourth_order(const char* body, const Errors& coarse, const Errors& fine)
{
    const auto order = [](double twice, double once) { return std::log2(std::abs(twice / once)); };
    const double of_area = order(coarse.curved.area_mm2, fine.curved.area_mm2);
    const double of_volume = order(coarse.curved.volume_mm3, fine.curved.volume_mm3);
    fmt::print("{}: area off by {:.1e} (flat {:.1e}), order {:.1f}; volume {:.1e} ({:.1e}), order {:.1f}\n", body,
               fine.curved.area_mm2, fine.flat.area_mm2, of_area, fine.curved.volume_mm3, fine.flat.volume_mm3,
               of_volume);
    EXPECT_GT(of_area, 3.5);
    EXPECT_GT(of_volume, 3.5);
    EXPECT_LT(std::abs(fine.curved.area_mm2), 0.03 * std::abs(fine.flat.area_mm2));
    EXPECT_LT(std::abs(fine.curved.volume_mm3), 0.03 * std::abs(fine.flat.volume_mm3));
}

/// Vertices exactly on the surface.
TriangleMesh ellipsoid(const Vec3& axes, double edge)
{
    TriangleMesh mesh = geometry::make_ellipsoid({1, 1, 1}, edge);
    for (Vec3& v : mesh.vertices)
    {
        v = normalized(v);
        v = {axes.x * v.x, axes.y * v.y, axes.z * v.z};
    }
    return mesh;
}

/// Radii 2 and 1, from a grid whose vertices are moved along the surface by up to a tenth of their distance.
TriangleMesh torus(int sectors)
{
    TriangleMesh mesh;
    const int around = 2 * sectors;
    std::uint64_t counter = 0;
    const auto shift = [&] { return 0.2 * (hash_uniform(1, counter++) - 0.5); };
    const auto at = [&](int i, int j) { return i % around * sectors + j % sectors; };
    for (int i = 0; i < around; ++i)
    {
        for (int j = 0; j < sectors; ++j)
        {
            const double u = 2.0 * pi * (i + shift()) / around;
            const double v = 2.0 * pi * (j + shift()) / sectors;
            const double r = 2.0 + std::cos(v);
            mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// Two balls of radius 1 whose centres lie 1.2 apart: a groove with a sharp bottom.
TriangleMesh two_balls(int rings)
{
    const double end = pi - std::acos(0.6);
    std::vector<test::ProfilePoint> profile;
    for (int k = 1; k < 2 * rings; ++k)
    {
        const double angle = end * std::min(k, 2 * rings - k) / rings;
        const double z = 0.6 + std::cos(angle);
        profile.push_back({std::sin(angle), k < rings ? -z : z});
    }
    profile[rings - 1].z = 0.0;
    return test::turned(profile, -1.6, 1.6, static_cast<int>(2.0 * pi * rings / end));
}

TEST(CurvedSurface, OfASphereIsOfFourthOrder)
{
    const metrics::CurvedSize exact{4.0 * pi, 4.0 / 3.0 * pi};
    expect_fourth_order("sphere", errors(ellipsoid({1, 1, 1}, 0.4), exact), errors(ellipsoid({1, 1, 1}, 0.2), exact));
}

TEST(CurvedSurface, OfAnEllipsoidIsOfFourthOrder)
{
    const double a = 6.0;
    const double c = 10.0;
    const double e = std::sqrt(1.0 - a * a / (c * c));
    const metrics::CurvedSize exact{2.0 * pi * a * a * (1.0 + c / (a * e) * std::asin(e)), 4.0 / 3.0 * pi * a * a * c};
    expect_fourth_order("ellipsoid", errors(ellipsoid({a, a, c}, 0.4), exact),
                        errors(ellipsoid({a, a, c}, 0.2), exact));
}

TEST(CurvedSurface, OfATorusIsOfFourthOrder)
{
    const metrics::CurvedSize exact{8.0 * pi * pi, 4.0 * pi * pi};
    expect_fourth_order("torus", errors(torus(16), exact), errors(torus(32), exact));
}

TEST(CurvedSurface, ACreaseDoesNotFoolIt)
{
    const double cap = 0.4; // height of what each ball loses
    const metrics::CurvedSize exact{2.0 * (4.0 * pi - 2.0 * pi * cap),
                                    2.0 * (4.0 / 3.0 * pi - pi * cap * cap * (3.0 - cap) / 3.0)};
    for (const int rings : {8, 16})
    {
        const Errors e = errors(two_balls(rings), exact);
        fmt::print("two balls, {} rings: area off by {:.4f} (flat {:.4f}), volume {:.4f} ({:.4f})\n", rings,
                   e.curved.area_mm2, e.flat.area_mm2, e.curved.volume_mm3, e.flat.volume_mm3);
        EXPECT_LT(std::abs(e.curved.area_mm2), 0.4 * std::abs(e.flat.area_mm2));
        EXPECT_LT(std::abs(e.curved.volume_mm3), 0.4 * std::abs(e.flat.volume_mm3));
    }
}

TEST(CurvedSurface, HardlyHeedsTrianglesWithoutArea)
{
    TriangleMesh mesh = ellipsoid({1, 1, 1}, 0.3);
    const metrics::CurvedSize whole = metrics::curved_size(mesh.vertices, mesh.triangles);
    const auto [a, b, c] = mesh.triangles[0];
    mesh.triangles.push_back({a, b, a});
    mesh.vertices.push_back(mesh.vertices[b]);
    mesh.triangles.push_back({b, static_cast<std::int32_t>(mesh.vertices.size()) - 1, b});
    const metrics::CurvedSize more = metrics::curved_size(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(more.area_mm2 / whole.area_mm2, 1.0, 1e-6);
    EXPECT_NEAR(more.volume_mm3 / whole.volume_mm3, 1.0, 1e-6);
}

TEST(CurvedSurface, IsTheSameAnywhereAndForAnyNumberOfThreads)
{
    TriangleMesh mesh = ellipsoid({12, 9, 7}, 0.1);
    const int threads = thread_count();
    const metrics::CurvedSize size = metrics::curved_size(mesh.vertices, mesh.triangles);
    set_thread_count(1);
    const metrics::CurvedSize alone = metrics::curved_size(mesh.vertices, mesh.triangles);
    set_thread_count(threads);
    EXPECT_EQ(size.area_mm2, alone.area_mm2);
    EXPECT_EQ(size.volume_mm3, alone.volume_mm3);
    for (Vec3& v : mesh.vertices)
    {
        v += {1e4, -2e4, 3e4};
    }
    const metrics::CurvedSize moved = metrics::curved_size(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(moved.area_mm2 / size.area_mm2, 1.0, 1e-9);
    EXPECT_NEAR(moved.volume_mm3 / size.volume_mm3, 1.0, 1e-9);
}

} // namespace
} // namespace corticle
