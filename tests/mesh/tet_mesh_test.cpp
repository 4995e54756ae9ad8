// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/tet_mesh.hpp"

#include "corticle/geometry/validate.hpp"
#include "geometry/simple_tets.hpp"
#include "mesh/mesh_volume.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace corticle
{
namespace
{

using test::tet_ball;
using test::tet_box;

const TetMesh unit{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};

TEST(TetMesh, VolumeIsPositiveWhenRightHanded)
{
    EXPECT_DOUBLE_EQ(signed_volume(unit.vertices, {0, 1, 2, 3}), 1.0 / 6.0);
    EXPECT_DOUBLE_EQ(signed_volume(unit.vertices, {0, 1, 3, 2}), -1.0 / 6.0);
}

TEST(TetMesh, FacesOfARightHandedTetLookOutward)
{
    const Vec3 centre{0.25, 0.25, 0.25};
    for (std::size_t k = 0; k < 4; ++k)
    {
        const Vec3& a = unit.vertices[tet_faces[k][0]];
        const Vec3& b = unit.vertices[tet_faces[k][1]];
        const Vec3& c = unit.vertices[tet_faces[k][2]];
        EXPECT_GT(dot(cross(b - a, c - a), a - centre), 0.0) << k;
        EXPECT_LT(dot(cross(b - a, c - a), unit.vertices[k] - a), 0.0) << k;
    }
}

TEST(TetMesh, VolumesOfABoxAddUp)
{
    const TetMesh box = tet_box(5, {1, 2, 3}, {2, 4, 6});
    for (const double volume : tet_volumes(box))
    {
        EXPECT_NEAR(volume, 6.0 / (125 * 6), 1e-12);
    }
    EXPECT_NEAR(mesh_volume(box), 6.0, 1e-12);
    const std::vector<double> nodes = node_volumes(box);
    EXPECT_NEAR(std::accumulate(nodes.begin(), nodes.end(), 0.0), 6.0, 1e-12);
    EXPECT_GT(*std::min_element(nodes.begin(), nodes.end()), 0.0);
    EXPECT_NEAR(nodes[(1 * 6 + 1) * 6 + 1], 6.0 / 125, 1e-12); // an inner node has a whole brick
}

TEST(TetMesh, MeanRatioIsOneForARegularTetAndZeroForAFlatOne)
{
    const std::vector<Vec3> regular{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    EXPECT_NEAR(mean_ratio(regular, {0, 1, 2, 3}), 1.0, 1e-14);
    EXPECT_NEAR(mean_ratio(regular, {0, 1, 3, 2}), 1.0, 1e-14);
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(mean_ratio(flat, {0, 1, 2, 3}), 0.0);
    EXPECT_EQ(mean_ratio(flat, {0, 0, 0, 0}), 0.0);
}

TEST(TetMesh, NeighboursShareAFace)
{
    const TetMesh box = tet_box(3, {0, 0, 0}, {1, 1, 1});
    FaceFault fault;
    const TetNeighbors neighbors = tet_neighbors(box, &fault);
    EXPECT_EQ(fault.crowded, 0);
    EXPECT_EQ(fault.same_side, 0);
    std::int64_t without = 0;
    for (std::size_t i = 0; i < neighbors.size(); ++i)
    {
        for (std::size_t k = 0; k < 4; ++k)
        {
            const std::int32_t other = neighbors[i][k];
            without += other < 0 ? 1 : 0;
            if (other >= 0)
            {
                const Tet& tet = box.tets[other];
                for (const int corner : tet_faces[k])
                {
                    EXPECT_NE(std::find(tet.begin(), tet.end(), box.tets[i][corner]), tet.end());
                }
                EXPECT_EQ(std::count(neighbors[other].begin(), neighbors[other].end(), static_cast<std::int32_t>(i)),
                          1);
            }
        }
    }
    EXPECT_EQ(without, 6 * 9 * 2);
}

TEST(TetMesh, BoundaryIsAValidSurfaceOfTheSameVolume)
{
    const TetMesh ball = tet_ball(8, 10.0);
    const TetBoundary boundary = boundary_of(ball);
    EXPECT_NO_THROW(geometry::require_valid_surface(boundary.surface, "ball"));
    EXPECT_NEAR(enclosed_volume(boundary.surface.vertices, boundary.surface.triangles) / mesh_volume(ball), 1.0, 1e-12);
    EXPECT_TRUE(std::is_sorted(boundary.nodes.begin(), boundary.nodes.end()));
    ASSERT_EQ(boundary.nodes.size(), boundary.surface.vertices.size());
    for (std::size_t v = 0; v < boundary.nodes.size(); ++v)
    {
        EXPECT_EQ(ball.vertices[boundary.nodes[v]], boundary.surface.vertices[v]);
        EXPECT_NEAR(norm(boundary.surface.vertices[v]), 10.0, 1e-12);
    }
}

} // namespace
} // namespace corticle
