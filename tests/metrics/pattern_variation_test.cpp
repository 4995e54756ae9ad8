// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/pattern_variation.hpp"

#include "corticle/geometry/shapes.hpp"
#include "corticle/metrics/fold_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace corticle::metrics
{
namespace
{

const TriangleMesh& plain()
{
    static const TriangleMesh mesh = geometry::make_ellipsoid({20.0, 24.0, 16.0}, 2.0);
    return mesh;
}

/// Furrows of a depth, moved along z by a phase.
TriangleMesh folded(double depth, double phase)
{
    TriangleMesh mesh = plain();
    for (Vec3& x : mesh.vertices)
    {
        x = (1.0 - depth * (1.0 + std::sin(0.5 * x.y + 0.45 * x.z + phase))) * x;
    }
    return mesh;
}

SurfaceView view(const TriangleMesh& mesh)
{
    return {mesh.vertices, mesh.triangles};
}

PatternVariation variation(const std::vector<TriangleMesh>& meshes)
{
    std::vector<SurfaceView> views;
    std::ranges::transform(meshes, std::back_inserter(views), view);
    return pattern_variation(view(plain()), views);
}

TEST(PatternVariation, TheSameFoldsAgreeAndDoNotVary)
{
    const PatternVariation found = variation({folded(0.06, 0.0), folded(0.06, 0.0), folded(0.06, 0.0)});
    EXPECT_NEAR(found.depth.mean, 1.0, 1e-12);
    EXPECT_NEAR(found.curvature.lowest, 1.0, 1e-12);
    EXPECT_NEAR(found.dice.mean, 1.0, 1e-12);
    EXPECT_LT(*std::ranges::max_element(found.depth_sd), 1e-9);
    for (const double share : found.sulcal_share)
    {
        EXPECT_TRUE(share == 0.0 || share == 1.0);
    }
}

TEST(PatternVariation, OppositeFoldsDisagree)
{
    const PatternVariation found = variation({folded(0.06, 0.0), folded(0.06, std::numbers::pi)});
    EXPECT_LT(found.depth.mean, -0.5);
    EXPECT_LT(found.curvature.mean, -0.5);
    EXPECT_LT(found.dice.mean, 0.2);
}

TEST(PatternVariation, MeanAndDeviationAreThoseOfTheDepths)
{
    const std::vector<TriangleMesh> meshes{folded(0.02, 0.0), folded(0.05, 0.4), folded(0.07, 0.9)};
    const PatternVariation found = variation(meshes);
    std::array<std::vector<double>, 3> depths;
    std::ranges::transform(meshes, depths.begin(),
                           [](const TriangleMesh& mesh) { return fold_features(view(mesh)).depth; });
    for (std::size_t v = 0; v < plain().vertices.size(); v += 53)
    {
        const double a = depths[0][v];
        const double b = depths[1][v];
        const double c = depths[2][v];
        EXPECT_NEAR(found.depth_mean[v], (a + b + c) / 3.0, 1e-12);
        const double pairs = (a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a);
        EXPECT_NEAR(found.depth_sd[v], std::sqrt(pairs / 6.0), 1e-12); // n - 1 = 2 of three
    }
    EXPECT_LE(found.depth.lowest, found.depth.mean);
    EXPECT_GE(found.depth.highest, found.depth.mean);
    EXPECT_GT(found.depth.highest, found.depth.lowest);
}

} // namespace
} // namespace corticle::metrics
