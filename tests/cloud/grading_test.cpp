// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/depth_profile.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/cloud/interior.hpp"
#include "corticle/cloud/neighbors.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace corticle
{
namespace
{

constexpr double radius = 10.0;
constexpr double spacing = 0.6;
constexpr cloud::Grading grading{2.0, 1.0};

struct GradedBall
{
    TriangleMesh surface = geometry::make_ellipsoid({radius, radius, radius}, cloud::edge_per_spacing* spacing);
    geometry::SurfaceTree tree{surface.vertices, surface.triangles};
    Cloud cloud = cloud::fill_surface(surface, {spacing, 1, grading});
};

const GradedBall& ball()
{
    static const GradedBall made;
    return made;
}

/// The integral of 1 / spacing³ over a ball, by shells.
double exact_count(double at_surface)
{
    constexpr int shells = 4000;
    constexpr double step = radius / shells;
    double count = 0.0;
    for (int k = 0; k < shells; ++k)
    {
        const double r = (k + 0.5) * step;
        count += 4.0 * std::numbers::pi * r * r * step * std::pow(grading.spacing_at(at_surface, radius - r), -3.0);
    }
    return count;
}

TEST(Grading, SpacingGrowsFromTheCortexToTheCore)
{
    EXPECT_EQ(grading.spacing_at(spacing, 0.0), spacing);
    EXPECT_EQ(grading.spacing_at(spacing, 1.0 + 2.5 * spacing), spacing);
    EXPECT_NEAR(grading.spacing_at(spacing, 1.0 + 2.5 * spacing + 1.0), spacing + 0.25, 1e-12);
    EXPECT_EQ(grading.spacing_at(spacing, 9.0), 2.0 * spacing);
    EXPECT_EQ(cloud::Grading{}.spacing_at(spacing, 9.0), spacing);
}

TEST(Grading, ParticlesAreCountedFromTheDepths)
{
    const cloud::DepthProfile profile(ball().tree);
    const double count = exact_count(spacing);
    EXPECT_NEAR(profile.count(spacing, grading) / count, 1.0, 0.01);
    EXPECT_NEAR(profile.spacing_for(count, grading), spacing, 0.005 * spacing);
    EXPECT_NEAR(static_cast<double>(ball().cloud.positions.size()) / count, 1.0, 0.01);
}

TEST(Grading, CellsAreAsLargeAsTheSpacingSays)
{
    const Cloud& cloud = ball().cloud;
    const double total = std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0);
    EXPECT_NEAR(total / enclosed_volume(ball().surface.vertices, ball().surface.triangles), 1.0, 1e-12);
    EXPECT_EQ(cloud.spacing, spacing);
    EXPECT_EQ(cloud.largest_spacing(), 2.0 * spacing);
    double squares = 0.0;
    std::int64_t inside = 0;
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
        const double h = cloud.spacing_at(i);
        if (radius - norm(cloud.positions[i]) > 1.5 * spacing)
        {
            const double relative = cloud.volumes[i] / (h * h * h);
            ASSERT_GT(relative, 0.3);
            ASSERT_LT(relative, 2.5);
            squares += (relative - 1.0) * (relative - 1.0);
            ++inside;
        }
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(inside)), 0.3);
}

TEST(Grading, PairsAndWeightsAreSymmetric)
{
    const Cloud& cloud = ball().cloud;
    const Neighbors pairs = cloud::find_neighbors(cloud, ball().tree, 2.3 * spacing);
    const double mean = static_cast<double>(pairs.index.size()) / static_cast<double>(cloud.positions.size());
    EXPECT_NEAR(mean, 44.0, 6.0); // as in a cloud of one spacing
    const tlsph::Particles particles = tlsph::make_particles(cloud, pairs, {});
    const auto weight = [&](std::int64_t i, std::int64_t j)
    {
        for (std::int64_t k = particles.pairs.begin[i]; k < particles.pairs.begin[i + 1]; ++k)
        {
            if (particles.pairs.neighbor(i, k) == j)
            {
                return particles.pairs.weight[k];
            }
        }
        return -1.0F;
    };
    for (std::int64_t i = 0; i < std::ssize(cloud.positions); i += 7)
    {
        for (std::int64_t k = particles.pairs.begin[i]; k < particles.pairs.begin[i + 1]; ++k)
        {
            ASSERT_EQ(particles.pairs.weight[k], weight(particles.pairs.neighbor(i, k), i));
        }
    }
}

TEST(Grading, DependsOnTheSeedOnly)
{
    const Cloud again = cloud::fill_surface(ball().surface, {spacing, 1, grading});
    EXPECT_EQ(again.positions, ball().cloud.positions);
    const Cloud other = cloud::fill_surface(ball().surface, {spacing, 2, grading});
    EXPECT_NE(other.positions, ball().cloud.positions);
}

} // namespace
} // namespace corticle
