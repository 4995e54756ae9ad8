// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/solver.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/material/neo_hookean.hpp"
#include "mechanics/fem/small_tets.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace corticle
{
namespace
{

using test::affine;
using test::ElementBody;

const Mat3 stretch{{{1.2, 0.05, -0.1}, {0.1, 0.9, 0.2}, {-0.15, 0.1, 1.1}}};

/// The block of eight is padded; the padding is not a tet and has no J.
TEST(FemExactness, SmallestJOfATetCountThatIsNoMultipleOfEight)
{
    const ElementBody body = test::plain_elements(test::tet_box(3, {-1, -1, -1}, {1, 1, 1}));
    ASSERT_NE(body.elements.tets.size() % 8, 0u);
    fem::FemSolver solver(body.elements, body.tissue);
    const std::vector<Vec3> x = affine(body.elements.X, stretch);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, 0.0, forces);
    EXPECT_NEAR(response.smallest_J, determinant(stretch), 1e-12);
    ASSERT_GE(response.smallest_J_at, 0);
    EXPECT_LT(response.smallest_J_at, std::ssize(body.elements.tets));
    EXPECT_EQ(response.extrapolated_count + response.inverted_count, 0);
}

/// Every inner node of an irregular mesh is in equilibrium under an affine motion, and F is that of the motion.
TEST(FemExactness, PatchTest)
{
    TetMesh mesh = test::tet_box(4, {-1, -1, -1}, {1, 1, 1});
    std::vector<char> is_inner(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        const Vec3& X = mesh.vertices[i];
        is_inner[i] = std::max({std::abs(X.x), std::abs(X.y), std::abs(X.z)}) < 0.99;
        mesh.vertices[i] += (is_inner[i] ? 0.08 : 0.0) * test::random_vector(3, i);
    }
    const ElementBody body = test::plain_elements(mesh);
    fem::FemSolver solver(body.elements, body.tissue);
    const std::vector<Vec3> x = affine(mesh.vertices, stretch, {3.0, -7.0, 2.0});
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, 0.0, forces);
    // W of the law at this F, everywhere.
    const material::ElasticResponse expected = material::elastic_response(material::NeoHookean{0.3}, 1.0, 5.0, stretch);
    EXPECT_NEAR(response.elastic_energy / (8.0 * (expected.deviatoric_energy + expected.volumetric_energy)), 1.0,
                1e-12);
    EXPECT_NEAR(response.smallest_J, determinant(stretch), 1e-12);
    for (const Mat3& F : solver.deformation_gradients(x))
    {
        EXPECT_LT(test::largest_difference(F, stretch), 1e-12);
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        if (is_inner[i])
        {
            EXPECT_LT(norm(forces[i]), 1e-13);
        }
    }
    Mat3 moment; // what the surface is pulled with: sum f X^T = -V P
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        moment += outer(forces[i], mesh.vertices[i]);
    }
    EXPECT_LT(test::largest_difference(moment, (-8.0) * expected.stress), 1e-12);
}

TEST(FemExactness, InvertedElementsSurviveAndAreCounted)
{
    ElementBody body = test::layered_block();
    body.tissue.options.barrier_J = 0.0;
    fem::FemSolver solver(body.elements, body.tissue);
    std::vector<Vec3> x = body.elements.X;
    // A node pushed through the opposite face of one of its tets.
    const Tet& tet = body.elements.tets[1500];
    const Vec3 face = (1.0 / 3.0) * (x[tet[1]] + x[tet[2]] + x[tet[3]]);
    x[tet[0]] += 1.3 * (face - x[tet[0]]);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, 0.0, forces);
    EXPECT_EQ(response.invalid_at, -1);
    EXPECT_LT(response.smallest_J, 0.0);
    EXPECT_GE(response.inverted_count, 1);
    EXPECT_GE(response.extrapolated_count, response.inverted_count);
    EXPECT_LT(response.extrapolated_count, 20);
    EXPECT_TRUE(std::isfinite(response.elastic_energy));
    // The forces push the node back.
    EXPECT_LT(dot(forces[tet[0]], face - body.elements.X[tet[0]]), 0.0);
}

TEST(FemExactness, ACollapsedNodeOrNaNIsInvalidAndDescribed)
{
    const ElementBody body = test::layered_block();
    fem::FemSolver solver(body.elements, body.tissue);
    std::vector<Vec3> forces(body.elements.X.size());
    const std::vector<Vec3> mirrored = affine(body.elements.X, Mat3::diagonal(-1, 1, 1));
    EXPECT_EQ(solver.evaluate(mirrored, 0.0, forces).invalid_at, 0);
    EXPECT_NE(solver.diagnosis(0, mirrored).find("J = -1"), std::string::npos);
    std::vector<Vec3> x = body.elements.X;
    x[123].y = std::nan("");
    EXPECT_GE(solver.evaluate(x, 0.0, forces).invalid_at, 0);
}

TEST(FemElements, PartsOfTheNodesHoldEveryTetOnce)
{
    const ElementBody body = test::layered_block();
    const fem::TetElements& elements = body.elements;
    EXPECT_EQ(elements.part.size(), elements.chunk_node.size());
    for (std::size_t e = 0; e < elements.tets.size(); ++e)
    {
        for (std::size_t a = 0; a < 4; ++a)
        {
            const std::int64_t first = elements.chunk_begin[e / parallel_block];
            const std::uint16_t corner = elements.blocks[e / wide_lanes].corner[a][e % wide_lanes];
            ASSERT_EQ(elements.chunk_node[first + corner], elements.tets[e][a]);
        }
    }
    EXPECT_NEAR(std::accumulate(elements.node_volume.begin(), elements.node_volume.end(), 0.0),
                std::accumulate(elements.volume.begin(), elements.volume.end(), 0.0), 1e-10);
}

TEST(FemElements, ATetWithoutVolumeIsRefused)
{
    TetMesh mesh = test::tet_box(1, {0, 0, 0}, {1, 1, 1});
    std::swap(mesh.tets[3][0], mesh.tets[3][1]);
    EXPECT_THROW(fem::make_elements(mesh.vertices, mesh.tets, 1.0), InputError);
}

} // namespace
} // namespace corticle
