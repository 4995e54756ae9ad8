// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/enriched_gradient.hpp"

#include "mechanics/tlsph/plate.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using Reach = tlsph::EnrichedGradients::Reach;

const test::Plate& plate()
{
    static const test::Plate made(6);
    return made;
}

/// Whether no support reaches the rim.
bool is_far_from_the_rim(const Vec3& X)
{
    constexpr double rim = 24.0 - 2.0 * 2.3;
    return std::abs(X.x) < rim && std::abs(X.y) < rim;
}

TEST(EnrichedGradient, ReachesASupportBelowTheSurface)
{
    const tlsph::EnrichedGradients& enriched = plate().particles.enriched;
    for (std::size_t i = 0; i < plate().cloud.positions.size(); ++i)
    {
        const Vec3& X = plate().cloud.positions[i];
        if (is_far_from_the_rim(X))
        {
            const double depth = 3.0 - std::abs(X.z);
            ASSERT_TRUE(depth > 1.7 || enriched.reach[i] == Reach::itself) << depth;
            ASSERT_TRUE(depth < 2.3 || enriched.reach[i] != Reach::itself) << depth;
        }
    }
}

/// What bends a plate: (n . X) times what is tangential, whose gradient at the centroid is exact but for 0.001.
TEST(EnrichedGradient, IsThatOfBendingAtTheCentroid)
{
    const Cloud& cloud = plate().cloud;
    std::vector<Vec3> x;
    for (const Vec3& X : cloud.positions)
    {
        x.push_back(X + Vec3{0.01 * X.z * X.x, 0.02 * X.z * X.y, -0.005 * X.x * X.x - 0.01 * X.y * X.y});
    }
    tlsph::TlsphSolver solver(plate().particles, plate().tissue);
    const std::vector<Mat3> F = solver.deformation_gradients(x);
    const tlsph::Particles linear = test::without_enrichment(plate().particles);
    const std::vector<Mat3> linear_F = tlsph::TlsphSolver(linear, plate().tissue).deformation_gradients(x);
    double error = 0.0;
    double linear_error = 0.0;
    std::int64_t count = 0;
    for (const std::int32_t i : cloud.surface_particles)
    {
        if (is_far_from_the_rim(cloud.positions[i]))
        {
            const double z = cloud.centroids[i].z;
            error += std::abs(F[i](0, 0) - 1.0 - 0.01 * z) + std::abs(F[i](1, 1) - 1.0 - 0.02 * z);
            linear_error += std::abs(linear_F[i](0, 0) - 1.0 - 0.01 * z) + std::abs(linear_F[i](1, 1) - 1.0 - 0.02 * z);
            ++count;
        }
    }
    ASSERT_GT(count, 1000);
    EXPECT_LT(error, 0.1 * linear_error);
}

TEST(EnrichedGradient, PairsThatNeedItComeFirst)
{
    const tlsph::Particles& p = plate().particles;
    for (std::int64_t i = 0; i < std::ssize(p.X); ++i)
    {
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            ASSERT_EQ(p.enriched.reach[p.pairs.neighbor(i, k)] == Reach::itself, k < p.pairs.enriched_end[i]);
        }
    }
}

TEST(EnrichedGradient, IsLeftOutWhereNormalsCancel)
{
    const test::Plate thin(2); // its middle layer sees both faces
    for (std::size_t i = 0; i < thin.cloud.positions.size(); ++i)
    {
        const Vec3& X = thin.cloud.positions[i];
        if (std::abs(X.x) < 5.0 && std::abs(X.y) < 5.0 && std::abs(X.z) < 0.02)
        {
            EXPECT_NE(thin.particles.enriched.reach[i], Reach::itself) << "particle " << i;
        }
    }
}

} // namespace
} // namespace corticle
