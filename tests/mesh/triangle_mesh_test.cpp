// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/triangle_mesh.hpp"

#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace corticle
{
namespace
{

TEST(TriangleMesh, MeasuresABox)
{
    const TriangleMesh box = test::box({1, 2, 3}, {2, 4, 6});
    EXPECT_NEAR(enclosed_volume(box.vertices, box.triangles), 6.0, 1e-12);
    EXPECT_NEAR(surface_area(box.vertices, box.triangles), 22.0, 1e-12);
    const std::vector<double> areas = vertex_areas(box.vertices, box.triangles);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 22.0, 1e-12);
}

TEST(TriangleMesh, VolumeOfATurnedSurfaceIsNegative)
{
    TriangleMesh box = test::box({0, 0, 0}, {1, 1, 1});
    for (Triangle& t : box.triangles)
    {
        std::swap(t[1], t[2]);
    }
    EXPECT_NEAR(enclosed_volume(box.vertices, box.triangles), -1.0, 1e-14);
}

TEST(TriangleMesh, VolumeFarFromTheOriginKeepsItsDigits)
{
    const TriangleMesh box = test::box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1});
    EXPECT_NEAR(enclosed_volume(box.vertices, box.triangles), 1.0, 1e-9);
}

TEST(TriangleMesh, CornerNormalsOfACubeDoNotDependOnItsDiagonals)
{
    // With weights by angle all three faces count a right angle at each corner, however they are split.
    const TriangleMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    const std::vector<Vec3> normals = vertex_normals(box.vertices, box.triangles);
    for (std::size_t v = 0; v < box.vertices.size(); ++v)
    {
        EXPECT_NEAR(norm(normals[v] - normalized(box.vertices[v])), 0.0, 1e-14);
    }
}

TEST(TriangleMesh, EmptySurfaceMeasuresZero)
{
    EXPECT_EQ(enclosed_volume({}, {}), 0.0);
    EXPECT_EQ(surface_area({}, {}), 0.0);
}

} // namespace
} // namespace corticle
