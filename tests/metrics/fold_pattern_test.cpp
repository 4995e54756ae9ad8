// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_pattern.hpp"

#include "corticle/geometry/shapes.hpp"
#include "imaging/label_shapes.hpp"

#include <gtest/gtest.h>

namespace corticle::metrics
{
namespace
{

const TriangleMesh& plain()
{
    static const TriangleMesh mesh = geometry::make_ellipsoid({20.0, 30.0, 16.0}, 1.5);
    return mesh;
}

/// Furrows that no mirror and no turn brings back.
TriangleMesh folded(double depth)
{
    TriangleMesh mesh = plain();
    for (Vec3& x : mesh.vertices)
    {
        const double wave = std::sin(0.5 * x.y + 0.25 * x.x) + std::sin(0.45 * x.z - 0.3 * x.x + 1.0);
        x = (1.0 - depth * (1.0 + wave)) * x;
    }
    return mesh;
}

SurfaceView view(const TriangleMesh& mesh)
{
    return {mesh.vertices, mesh.triangles};
}

TEST(FoldPattern, AlignmentFindsASimilarity)
{
    const TriangleMesh target = folded(0.04);
    TriangleMesh moving = target;
    const Mat3 turn = skew_rotation(0.12);
    for (Vec3& x : moving.vertices)
    {
        x = 0.8 * (turn * x) + Vec3{3.0, -2.0, 5.0};
    }
    double residual = -1.0;
    const Similarity found = align(view(moving), view(target), &residual);
    EXPECT_NEAR(found.scale, 1.25, 1e-9); // by volume
    EXPECT_LT(residual, 0.05);
    for (std::size_t v = 0; v < target.vertices.size(); v += 97)
    {
        EXPECT_LT(norm(found(moving.vertices[v]) - target.vertices[v]), 0.3);
    }
}

TEST(FoldPattern, ItselfIsRightAndItsMirrorImageIsNot)
{
    const TriangleMesh real = folded(0.04);
    const TriangleMesh run = folded(0.037); // the same furrows, shallower
    const FoldPattern pattern = fold_pattern(view(plain()), view(run), view(real));
    ASSERT_EQ(pattern.scores.size(), 7U);
    const PatternScore& right = pattern.scores[0];
    EXPECT_EQ(right.name, "run");
    EXPECT_GT(right.depth, 0.95);
    EXPECT_GT(right.curvature, 0.95);
    EXPECT_GT(right.dice, 0.8);     // shallower furrows are concave over less
    EXPECT_GE(right.pits_5mm, 0.5); // those shallower than the ridge height are missing
    EXPECT_GE(right.pits_10mm, right.pits_5mm);
    for (std::size_t k = 1; k < pattern.scores.size(); ++k)
    {
        EXPECT_LT(pattern.scores[k].depth, 0.6) << pattern.scores[k].name;
        EXPECT_LT(pattern.scores[k].curvature, 0.6) << pattern.scores[k].name;
    }
    EXPECT_NEAR(pattern.scores[1].depth, 0.0, 1e-6); // the first body knows nothing beyond itself
}

/// A groove about the waist, narrower than anything else: the largest curvature of all is that of its floor, and
/// negative.
TriangleMesh grooved(TriangleMesh mesh)
{
    for (Vec3& x : mesh.vertices)
    {
        x = (1.0 - 0.35 * std::exp(-x.y * x.y / 15.0)) * x;
    }
    return mesh;
}

TEST(FoldPattern, AFissureOfTheFirstBodyLeavesTheRestToTell)
{
    const TriangleMesh first = grooved(plain());
    const TriangleMesh real = grooved(folded(0.04));
    const TriangleMesh run = grooved(folded(0.037));
    const FoldPattern pattern = fold_pattern(view(first), view(run), view(real));
    EXPECT_GT(pattern.scores[0].depth, 0.9);
    EXPECT_GT(pattern.scores[0].curvature, 0.9);
}

} // namespace
} // namespace corticle::metrics
