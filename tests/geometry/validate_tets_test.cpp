// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/validate_tets.hpp"

#include "corticle/base/error.hpp"
#include "geometry/simple_tets.hpp"
#include "mesh/mesh_volume.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace corticle
{
namespace
{

using test::tet_ball;
using test::tet_box;
using test::together;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const TetMesh box = tet_box(3, {0, 0, 0}, {3, 3, 3});

std::string refusal(const TetMesh& mesh)
{
    try
    {
        geometry::require_valid_tets(mesh, "body.msh");
    }
    catch (const InputError& error)
    {
        EXPECT_THAT(error.what(), StartsWith("body.msh: "));
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        return error.what();
    }
    return {};
}

/// The mesh without the tets that `remove` names.
template <class Remove>
TetMesh without(TetMesh mesh, Remove&& remove)
{
    std::erase_if(mesh.tets, [&](const Tet& tet) { return remove(mesh, tet); });
    return mesh;
}

Vec3 centre(const TetMesh& mesh, const Tet& t)
{
    return 0.25 * (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]] + mesh.vertices[t[3]]);
}

TEST(ValidateTets, GoodMeshesPassUnchanged)
{
    for (const TetMesh& mesh : {box, tet_ball(6, 10.0)})
    {
        geometry::TetReport report;
        const TetMesh result = geometry::require_valid_tets(mesh, "body", &report);
        EXPECT_EQ(result.vertices, mesh.vertices);
        EXPECT_EQ(result.tets, mesh.tets);
        EXPECT_THAT(report.lines, IsEmpty());
        EXPECT_GT(report.smallest_mean_ratio, 0.05);
    }
}

TEST(ValidateTets, LeftHandedMeshIsFlipped)
{
    TetMesh left = box;
    for (Tet& tet : left.tets)
    {
        std::swap(tet[0], tet[1]);
    }
    geometry::TetReport report;
    const TetMesh result = geometry::require_valid_tets(left, "body", &report);
    EXPECT_NEAR(mesh_volume(result), 27.0, 1e-12);
    EXPECT_TRUE(report.is_left_handed);
    EXPECT_THAT(report.lines, ElementsAre("all 162 tets are left-handed: flipped"));
}

TEST(ValidateTets, SomeLeftHandedTetsAreFlipped)
{
    TetMesh mixed = box;
    std::swap(mixed.tets[7][0], mixed.tets[7][3]);
    std::swap(mixed.tets[70][1], mixed.tets[70][2]);
    geometry::TetReport report;
    EXPECT_NEAR(mesh_volume(geometry::require_valid_tets(mixed, "body", &report)), 27.0, 1e-12);
    EXPECT_FALSE(report.is_left_handed);
    EXPECT_THAT(report.lines, ElementsAre("2 of 162 tets are left-handed: flipped"));
}

TEST(ValidateTets, OrphansRepeatsAndDuplicatesAreCleanedUp)
{
    TetMesh dirty = together(tet_box(2, {0, 0, 0}, {1, 1, 1}), tet_box(2, {1, 0, 0}, {2, 1, 1}));
    dirty.vertices.insert(dirty.vertices.begin(), {9, 9, 9});
    for (Tet& tet : dirty.tets)
    {
        tet = {tet[0] + 1, tet[1] + 1, tet[2] + 1, tet[3] + 1};
    }
    dirty.tets.push_back({dirty.tets[3][1], dirty.tets[3][0], dirty.tets[3][3], dirty.tets[3][2]});
    geometry::TetReport report;
    const TetMesh clean = geometry::require_valid_tets(dirty, "body", &report);
    EXPECT_EQ(clean.vertices.size(), 2u * 27u - 9u);
    EXPECT_EQ(clean.tets.size(), 96u);
    EXPECT_NEAR(mesh_volume(clean), 2.0, 1e-12);
    EXPECT_THAT(report.lines,
                ElementsAre("9 nodes lie exactly on another one: merged",
                            "1 tets have the same nodes as another one: dropped", "1 nodes belong to no tet: dropped"));
}

TEST(ValidateTets, FlatTetsOnTheBoundaryAreDropped)
{
    TetMesh mesh = box;
    // A tet laid on the four corners of a square of the face x = 0.
    mesh.tets.push_back({0, 1, 4, 5});
    geometry::TetReport report;
    const TetMesh result = geometry::require_valid_tets(mesh, "body", &report);
    EXPECT_EQ(result.tets, box.tets);
    EXPECT_THAT(report.lines, ElementsAre("1 tets are flat: dropped"));
}

TEST(ValidateTets, FlatTetsInsideAreRefused)
{
    // Two prisms that meet in a square but cut it along different diagonals, with a flat tet between.
    TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}}, {}};
    mesh.tets = {{0, 1, 2, 4}, {0, 2, 3, 4}, {1, 0, 3, 5}, {1, 3, 2, 5}, {0, 1, 2, 3}};
    EXPECT_THAT(refusal(mesh), HasSubstr("(once 1 flat tets are dropped)"));
}

TEST(ValidateTets, RefusesMeshesOfNoVolumeOrOfSlivers)
{
    TetMesh flat = box;
    TetMesh thin = box;
    for (std::size_t v = 0; v < box.vertices.size(); ++v)
    {
        flat.vertices[v].z = 0.5 * flat.vertices[v].x;
        thin.vertices[v].z *= 1e-3;
    }
    EXPECT_THAT(refusal({}), HasSubstr("no tets in the mesh"));
    // Flattened nodes coincide in columns: they are merged, and nothing is left.
    EXPECT_THAT(refusal(flat), HasSubstr("flat: no tet has a volume"));
    EXPECT_THAT(refusal(thin), HasSubstr("slivers: 162 of 162 tets"));
}

TEST(ValidateTets, NamesSliversThatItKeeps)
{
    TetMesh mesh = box;
    mesh.vertices[1 * 16 + 1 * 4 + 1] = {1e-3, 1, 1}; // an inner node close to the face x = 0
    geometry::TetReport report;
    geometry::require_valid_tets(mesh, "body", &report);
    EXPECT_GT(report.sliver_tets, 0);
    EXPECT_THAT(report.lines, ElementsAre(HasSubstr("tets are slivers")));
}

TEST(ValidateTets, RefusesBadNumbers)
{
    TetMesh mesh = box;
    mesh.vertices[5].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(mesh), HasSubstr("node 5 is not finite"));
    mesh = box;
    mesh.tets[4][2] = 64;
    EXPECT_THAT(refusal(mesh), HasSubstr("tet 4 refers to node 64; expected 0 to 63"));
    mesh.tets[4][2] = -1;
    EXPECT_THAT(refusal(mesh), HasSubstr("tet 4 refers to node -1"));
}

TEST(ValidateTets, RefusesInvertedTetsThatOverlap)
{
    TetMesh mesh = box;
    mesh.vertices[1 * 16 + 1 * 4 + 1] = {2.2, 2.1, 2.3}; // an inner node pulled through its tets
    EXPECT_THAT(refusal(mesh), HasSubstr("inverted tets: "));
}

TEST(ValidateTets, RefusesFacesOfThreeTets)
{
    TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}},
                 {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 1, 5}}};
    EXPECT_THAT(refusal(mesh), HasSubstr("not manifold: 1 faces with more than two tets"));
}

TEST(ValidateTets, RefusesSeveralParts)
{
    const TetMesh apart = together(tet_box(2, {0, 0, 0}, {1, 1, 1}), tet_box(1, {5, 0, 0}, {6, 1, 1}));
    EXPECT_THAT(refusal(apart), HasSubstr("2 parts that share no face, of 48, 6 tets; expected 1"));
    // Two bricks that meet in an edge only.
    const TetMesh hinge = without(tet_box(2, {0, 0, 0}, {2, 2, 2}),
                                  [](const TetMesh& mesh, const Tet& tet)
                                  {
                                      const Vec3 c = centre(mesh, tet);
                                      return (c.x < 1.0) != (c.y < 1.0);
                                  });
    EXPECT_THAT(refusal(hinge), HasSubstr("2 parts that share no face, of 12, 12 tets"));
}

TEST(ValidateTets, RefusesABoundaryThatIsNotManifold)
{
    // Two bricks at the lower face are gone that shared an edge.
    const TetMesh pinched = without(box,
                                    [](const TetMesh& mesh, const Tet& tet)
                                    {
                                        const Vec3 c = centre(mesh, tet);
                                        const bool first = c.x < 1.0 && c.y < 1.0 && c.z < 1.0;
                                        const bool second =
                                            c.x > 1.0 && c.x < 2.0 && c.y > 1.0 && c.y < 2.0 && c.z < 1.0;
                                        return first || second;
                                    });
    EXPECT_THAT(refusal(pinched), HasSubstr("boundary of the tets: not manifold: 1 edges"));
}

TEST(ValidateTets, RefusesABoundaryThatTouchesItselfInANode)
{
    const TetMesh pinched = without(box,
                                    [](const TetMesh& mesh, const Tet& tet)
                                    {
                                        const Vec3 c = centre(mesh, tet);
                                        const bool first = c.x < 1.0 && c.y < 1.0 && c.z < 1.0;
                                        const bool second =
                                            c.x > 1.0 && c.x < 2.0 && c.y > 1.0 && c.y < 2.0 && c.z > 1.0;
                                        return first || second;
                                    });
    EXPECT_THAT(refusal(pinched), HasSubstr("joins separate fans of triangles"));
}

TEST(ValidateTets, RefusesACavity)
{
    const TetMesh hollow = without(box,
                                   [](const TetMesh& mesh, const Tet& tet)
                                   {
                                       const Vec3 c = centre(mesh, tet) - Vec3{1.5, 1.5, 1.5};
                                       return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) < 0.5;
                                   });
    EXPECT_THAT(refusal(hollow), HasSubstr("boundary of the tets: 2 components; expected 1"));
}

} // namespace
} // namespace corticle
