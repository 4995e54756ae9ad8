// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/remesh.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/geometry/validate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{
namespace
{

TEST(Remesh, KeepsTheShapeAndMakesEvenEdges)
{
    const TriangleMesh input = geometry::make_ellipsoid({1.0, 1.3, 1.6}, 0.1);
    for (const double edge : {0.07, 0.2})
    {
        geometry::RemeshReport report;
        const TriangleMesh mesh = geometry::remesh_isotropic(input, edge, &report);
        EXPECT_NO_THROW(geometry::require_valid_surface(mesh, "remeshed"));
        // Chords of a curved surface: relative error about (edge / radius)² / 4.
        EXPECT_NEAR(report.area_change, 0.0, 0.25 * edge * edge + 1e-3);
        EXPECT_NEAR(report.volume_change, 0.0, 0.5 * edge * edge + 1e-3);
        EXPECT_LT(report.largest_distance_mm, edge * edge); // height of an arc of 0.7 mm radius over the longest edge
        std::vector<double> edges;
        for (const Triangle& t : mesh.triangles)
        {
            for (int k = 0; k < 3; ++k)
            {
                edges.push_back(norm(mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]) / edge);
            }
        }
        EXPECT_GT(*std::min_element(edges.begin(), edges.end()), 0.55);
        EXPECT_LT(*std::max_element(edges.begin(), edges.end()), 1.7);
        const geometry::SurfaceTree tree(input.vertices, input.triangles);
        for (const Vec3& p : mesh.vertices)
        {
            EXPECT_LT(tree.closest(p).squared_distance, 1e-24);
        }
    }
}

TEST(Remesh, IsRepeatable)
{
    const TriangleMesh input = geometry::make_ellipsoid({1.0, 1.3, 1.6}, 0.2);
    const TriangleMesh a = geometry::remesh_isotropic(input, 0.15);
    const TriangleMesh b = geometry::remesh_isotropic(input, 0.15);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Remesh, RefusesNonsense)
{
    EXPECT_THROW(geometry::remesh_isotropic(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.3), 0.0), InputError);
    EXPECT_THROW(geometry::remesh_isotropic({}, 1.0), InputError);
}

} // namespace
} // namespace corticle
