// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/fill.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/cells.hpp"
#include "corticle/cloud/quality.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/mesh/space_filling_curve.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace corticle
{
namespace
{

constexpr std::int64_t wanted = 6000;

struct Filled
{
    TriangleMesh surface;
    Cloud cloud;
};

Filled filled_ellipsoid(std::uint64_t seed = 1)
{
    const std::array<double, 3> axes{8.0, 10.0, 12.0};
    const double spacing = cloud::spacing_for_particles(4.0 / 3.0 * 3.14159265358979 * 960.0, wanted);
    Filled filled{geometry::make_ellipsoid(axes, 1.05 * spacing), {}};
    filled.cloud = cloud::fill_surface(filled.surface, {spacing, seed});
    return filled;
}

TEST(Fill, HasTheParticlesAskedForAndTheWholeVolume)
{
    const auto [surface, cloud] = filled_ellipsoid();
    EXPECT_NEAR(static_cast<double>(cloud.positions.size()), static_cast<double>(wanted), 0.02 * wanted);
    const double volume = enclosed_volume(surface.vertices, surface.triangles);
    const double sum = std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0);
    EXPECT_NEAR(sum / volume, 1.0, 1e-12);
    EXPECT_NEAR(std::pow(cloud.spacing, 3) * static_cast<double>(cloud.positions.size()) / volume, 1.0, 1e-12);
}

TEST(Fill, IsEven)
{
    const Cloud cloud = filled_ellipsoid().cloud;
    const cloud::CloudQuality quality = cloud::measure_quality(cloud);
    EXPECT_GT(quality.closest_pair_spacings, 0.7); // half a spacing is what the method needs
    EXPECT_GT(quality.smallest_volume, 0.3 * quality.mean_volume);
    EXPECT_LT(quality.largest_volume, 1.5 * quality.mean_volume);
}

TEST(Fill, SurfaceParticlesSitOnTheVerticesWithHalfACell)
{
    const auto [surface, cloud] = filled_ellipsoid();
    ASSERT_EQ(cloud.surface_particles.size(), surface.vertices.size());
    EXPECT_EQ(cloud.surface_triangles, surface.triangles);
    const std::set<std::int32_t> on_surface(cloud.surface_particles.begin(), cloud.surface_particles.end());
    EXPECT_EQ(on_surface.size(), surface.vertices.size());
    double surface_sum = 0.0;
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        EXPECT_EQ(cloud.positions[cloud.surface_particles[v]], surface.vertices[v]);
        surface_sum += cloud.volumes[cloud.surface_particles[v]];
    }
    const double total = enclosed_volume(surface.vertices, surface.triangles);
    const auto surface_count = static_cast<double>(on_surface.size());
    const double inside_mean = (total - surface_sum) / (static_cast<double>(cloud.positions.size()) - surface_count);
    EXPECT_NEAR(surface_sum / surface_count / inside_mean, 0.5, 0.1);
}

TEST(Fill, InnerParticlesKeepTheirDistanceFromTheSurface)
{
    const auto [surface, cloud] = filled_ellipsoid();
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    const std::set<std::int32_t> on_surface(cloud.surface_particles.begin(), cloud.surface_particles.end());
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
        if (!on_surface.contains(static_cast<std::int32_t>(i)))
        {
            EXPECT_LT(tree.signed_distance(cloud.positions[i]), -0.55 * cloud.spacing);
        }
    }
}

TEST(Fill, DependsOnTheSeedAndNotOnTheThreads)
{
    const int threads = thread_count();
    set_thread_count(1);
    const Cloud one = filled_ellipsoid().cloud;
    set_thread_count(2);
    const Cloud two = filled_ellipsoid().cloud;
    set_thread_count(threads);
    EXPECT_EQ(one.positions, two.positions);
    EXPECT_EQ(one.volumes, two.volumes);
    EXPECT_EQ(one.surface_particles, two.surface_particles);
    EXPECT_NE(one.positions, filled_ellipsoid(2).cloud.positions);
}

TEST(Fill, ThinAndCoarseBodiesStillFill)
{
    const TriangleMesh plate = geometry::make_ellipsoid({6.0, 6.0, 0.6}, 0.5);
    const Cloud thin = cloud::fill_surface(plate, {0.5, 1});
    EXPECT_GE(thin.positions.size(), plate.vertices.size());
    const TriangleMesh ball = geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.8);
    const Cloud coarse = cloud::fill_surface(ball, {0.8, 1});
    EXPECT_GE(coarse.positions.size(), ball.vertices.size());
    for (const double volume : thin.volumes)
    {
        EXPECT_GT(volume, 0.0);
    }
}

TEST(Fill, RefusesNonsense)
{
    const TriangleMesh box = test::box({0, 0, 0}, {1, 1, 1});
    EXPECT_THROW(cloud::fill_surface(box, {0.0, 1}), InputError);
    EXPECT_THROW(cloud::fill_surface(box, {1e-5, 1}), InputError);
    EXPECT_THROW(cloud::fill_surface({}, {1.0, 1}), InputError);
    EXPECT_THROW(cloud::spacing_for_particles(1.0, 0), InputError);
    EXPECT_DOUBLE_EQ(cloud::spacing_for_particles(8.0, 1000), 0.2);
}

TEST(CellVolumes, AreThoseOfALattice)
{
    // A cube of unit cells: points in their middles.
    const TriangleMesh box = test::box({0, 0, 0}, {4, 4, 4});
    std::vector<Vec3> points;
    for (int k = 0; k < 64; ++k)
    {
        points.push_back({0.5 + k / 16, 0.5 + k / 4 % 4, 0.5 + k % 4});
    }
    const std::vector<double> volumes = cloud::cells_of(box, points, 1.0).volumes;
    for (const double volume : volumes)
    {
        EXPECT_NEAR(volume, 1.0, 1e-9); // exact: the lines are spaced by 1/6, so each cell has 36 of them
    }
}

TEST(HilbertOrder, WalksTheLatticeByUnitSteps)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 512; ++k)
    {
        // 7 cells of 65535 / 7 steps: the octants of the curve fall between the points.
        points.push_back({k / 64 * 1.0, k / 8 % 8 * 1.0, k % 8 * 1.0});
    }
    const std::vector<std::int32_t> order = hilbert_order(points);
    for (std::size_t k = 1; k < order.size(); ++k)
    {
        EXPECT_DOUBLE_EQ(norm(points[order[k]] - points[order[k - 1]]), 1.0);
    }
}

} // namespace
} // namespace corticle
