// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/delaunay.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/random.hpp"
#include "mesh/mesh_volume.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace corticle
{
namespace
{

constexpr double none = std::numeric_limits<double>::infinity();

/// Points of a cubic lattice of spacing 1 that `inside` accepts, moved a little so that no five lie on a ball.
template <class Inside>
std::vector<Vec3> lattice(int count, Inside&& inside)
{
    std::vector<Vec3> points;
    for (int i = 0; i < count * count * count; ++i)
    {
        const Vec3 p{double(i % count), double(i / count % count), double(i / count / count)};
        if (inside(p))
        {
            const auto shake = [&](std::uint64_t axis)
            { return 0.02 * (hash_uniform(3, 3 * static_cast<std::uint64_t>(i) + axis) - 0.5); };
            points.push_back(p + Vec3{shake(0), shake(1), shake(2)});
        }
    }
    return points;
}

double area(const TriangleMesh& surface)
{
    double sum = 0.0;
    for (const double part : vertex_areas(surface.vertices, surface.triangles))
    {
        sum += part;
    }
    return sum;
}

TEST(Delaunay, WithoutALimitTheBoundaryIsTheConvexHull)
{
    const study::DelaunayBody body = study::delaunay_body(lattice(5, [](const Vec3&) { return true; }), none, "points");
    EXPECT_NEAR(mesh_volume(body.mesh), 64.0, 1.0);
    EXPECT_NEAR(area(body.boundary.surface), 96.0, 1.0);
    EXPECT_EQ(body.points_left_out, 0);
    for (const Tet& tet : body.mesh.tets)
    {
        EXPECT_GE(signed_volume(body.mesh.vertices, tet), 0.0);
    }
}

/// A slit that is two spacings wide stays open when the limit is below half its width and is bridged without one.
TEST(Delaunay, TheLimitDecidesWhetherASulcusIsBridged)
{
    const auto points = lattice(9, [](const Vec3& p) { return !(p.x > 3.5 && p.x < 5.5 && p.y > 2.5); });
    const study::DelaunayBody open = study::delaunay_body(points, 1.2, "points");
    const study::DelaunayBody bridged = study::delaunay_body(points, none, "points");
    // The slit is 3 wide, 6 deep and 8 long.
    EXPECT_NEAR(mesh_volume(bridged.mesh), 512.0, 5.0);
    EXPECT_NEAR(mesh_volume(open.mesh), 512.0 - 144.0, 10.0);
    EXPECT_NEAR(area(open.boundary.surface), 384.0 + 2.0 * 6.0 * 8.0 - 2.0 * 18.0, 8.0);
}

TEST(Delaunay, ALimitThatLeavesNothingIsRefused)
{
    const auto points = lattice(3, [](const Vec3&) { return true; });
    EXPECT_THROW(study::delaunay_body(points, 0.1, "points"), InputError);
    const std::vector<Vec3> plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    EXPECT_THROW(study::delaunay_body(plane, 10.0, "points"), InputError);
}

} // namespace
} // namespace corticle
