// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/from_tets.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/neighbors.hpp"
#include "corticle/cloud/quality.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/space_filling_curve.hpp"
#include "geometry/simple_tets.hpp"
#include "mesh/mesh_volume.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace corticle
{
namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Less
{
    bool operator()(const Vec3& a, const Vec3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};
using Places = std::set<Vec3, Less>;

double sum(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A ball of 21³ = 9261 nodes, irregular inside.
const TetMesh& ball()
{
    static const TetMesh mesh = test::tet_ball(20, 10.0);
    return mesh;
}

/// Its nodes moved along the radii: r / 10 becomes (r / 10)^power.
TetMesh graded_ball(int n, double power)
{
    TetMesh mesh = test::tet_ball(n, 10.0);
    for (Vec3& p : mesh.vertices)
    {
        p = norm(p) > 0.0 ? std::pow(norm(p) / 10.0, power - 1.0) * p : p;
    }
    return mesh;
}

Places particles_on_surface(const cloud::TetCloud& result)
{
    Places places;
    for (const std::int32_t particle : result.cloud.surface_particles)
    {
        places.insert(result.cloud.positions[particle]);
    }
    return places;
}

/// Shape matrices that are too ill-conditioned throw.
void require_good_gradients(const cloud::TetCloud& result)
{
    const geometry::SurfaceTree tree(result.surface.vertices, result.surface.triangles);
    const tlsph::TlsphOptions options;
    Neighbors pairs = cloud::find_neighbors(result.cloud, tree, options.support * result.cloud.spacing);
    EXPECT_NO_THROW(tlsph::make_particles(result.cloud, pairs, options));
}

void expect_consistent(const cloud::TetCloud& result)
{
    const Cloud& cloud = result.cloud;
    ASSERT_EQ(cloud.volumes.size(), cloud.positions.size());
    ASSERT_EQ(cloud.surface_particles.size(), result.surface.vertices.size());
    EXPECT_EQ(cloud.surface_triangles, result.surface.triangles);
    for (std::size_t v = 0; v < result.surface.vertices.size(); ++v)
    {
        EXPECT_EQ(cloud.positions[cloud.surface_particles[v]], result.surface.vertices[v]);
    }
    const double enclosed = enclosed_volume(result.surface.vertices, result.surface.triangles);
    EXPECT_NEAR(sum(cloud.volumes) / enclosed, 1.0, 1e-12);
    EXPECT_NEAR(std::pow(cloud.spacing, 3) * static_cast<double>(cloud.positions.size()) / enclosed, 1.0, 1e-12);
    EXPECT_GT(*std::min_element(cloud.volumes.begin(), cloud.volumes.end()), 0.0);
    const std::vector<std::int32_t> order = hilbert_order(cloud.positions);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(FromTets, EveryNodeBecomesAParticle)
{
    const cloud::TetCloud result = cloud::cloud_from_tets(ball());
    expect_consistent(result);
    EXPECT_EQ(Places(result.cloud.positions.begin(), result.cloud.positions.end()),
              Places(ball().vertices.begin(), ball().vertices.end()));
    EXPECT_EQ(result.cloud.positions.size(), ball().vertices.size());
    EXPECT_NEAR(sum(result.cloud.volumes) / mesh_volume(ball()), 1.0, 1e-12);
    EXPECT_EQ(result.surface.vertices.size(), boundary_of(ball()).nodes.size());
    require_good_gradients(result);
}

TEST(FromTets, VolumesFollowTheirNodes)
{
    const TetMesh box = test::tet_box(6, {0, 0, 0}, {6, 6, 6});
    const std::vector<double> expected = node_volumes(box);
    const Cloud cloud = cloud::cloud_from_tets(box).cloud;
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
        const auto node = std::find(box.vertices.begin(), box.vertices.end(), cloud.positions[i]);
        ASSERT_NE(node, box.vertices.end());
        EXPECT_EQ(cloud.volumes[i], expected[static_cast<std::size_t>(node - box.vertices.begin())]);
    }
}

TEST(FromTets, ThinnedUniformlyIsEvenAndKeepsNodesInside)
{
    constexpr std::int64_t wanted = 2000;
    const cloud::TetCloud result = cloud::cloud_from_tets(ball(), {wanted, cloud::Thinning::uniform, 1});
    expect_consistent(result);
    EXPECT_EQ(std::ssize(result.cloud.positions), wanted);
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_NEAR(result.remesh.volume_change, 0.0, 0.02);
    const cloud::CloudQuality quality = cloud::measure_quality(result.cloud);
    EXPECT_GT(quality.closest_pair_spacings, 0.6); // four nodes to choose from for each; half a spacing is needed
    EXPECT_LT(quality.largest_volume, 2.7 * quality.mean_volume);
    EXPECT_GT(quality.smallest_volume, 0.2 * quality.mean_volume);
    const Places nodes(ball().vertices.begin(), ball().vertices.end());
    const Places on_surface = particles_on_surface(result);
    for (const Vec3& place : result.cloud.positions)
    {
        EXPECT_TRUE(on_surface.contains(place) || nodes.contains(place));
    }
    require_good_gradients(result);
}

TEST(FromTets, ThinnedAtRandomHasTheParticlesAndSaysThatSomeAreClose)
{
    constexpr std::int64_t wanted = 3000;
    const cloud::TetCloud result = cloud::cloud_from_tets(ball(), {wanted, cloud::Thinning::random, 1});
    expect_consistent(result);
    EXPECT_EQ(std::ssize(result.cloud.positions), wanted);
    const double closest = cloud::measure_quality(result.cloud).closest_pair_spacings;
    EXPECT_LT(closest,
              cloud::measure_quality(cloud::cloud_from_tets(ball(), {wanted, cloud::Thinning::uniform, 1}).cloud)
                  .closest_pair_spacings);
    EXPECT_EQ(closest < 0.5, !result.warnings.empty());
}

TEST(FromTets, ThinningEvensOutAGradedMesh)
{
    // The density of nodes falls as 1 / r.
    const TetMesh mesh = graded_ball(20, 1.5);
    for (const cloud::Thinning thinning : {cloud::Thinning::random, cloud::Thinning::uniform})
    {
        const cloud::TetCloud result = cloud::cloud_from_tets(mesh, {1500, thinning, 1});
        const auto within = [&](double radius)
        {
            return static_cast<double>(std::count_if(result.cloud.positions.begin(), result.cloud.positions.end(),
                                                     [&](const Vec3& p) { return norm(p) < radius; }));
        };
        EXPECT_NEAR(within(5.0) / within(7.5), std::pow(5.0 / 7.5, 3), 0.06);
    }
}

TEST(FromTets, DependsOnTheSeedAndNotOnTheThreads)
{
    for (const cloud::Thinning thinning : {cloud::Thinning::random, cloud::Thinning::uniform})
    {
        const int threads = thread_count();
        const cloud::TetCloud first = cloud::cloud_from_tets(ball(), {2000, thinning, 5});
        set_thread_count(1);
        const cloud::TetCloud alone = cloud::cloud_from_tets(ball(), {2000, thinning, 5});
        set_thread_count(threads);
        EXPECT_EQ(first.cloud.positions, alone.cloud.positions);
        EXPECT_EQ(first.cloud.volumes, alone.cloud.volumes);
        EXPECT_NE(cloud::cloud_from_tets(ball(), {2000, thinning, 6}).cloud.positions, first.cloud.positions);
    }
}

TEST(FromTets, SaysWhenTheMeshIsTooCoarseInside)
{
    const cloud::TetCloud result = cloud::cloud_from_tets(graded_ball(10, 0.2), {1300, cloud::Thinning::uniform, 1});
    expect_consistent(result);
    EXPECT_LT(std::ssize(result.cloud.positions), 1300);
    ASSERT_FALSE(result.warnings.empty());
    EXPECT_THAT(result.warnings[0], HasSubstr("particles instead of 1300; a finer mesh is needed"));
}

TEST(FromTets, SaysWhenNodesAreTooClose)
{
    TetMesh mesh = test::tet_box(6, {0, 0, 0}, {6, 6, 6});
    mesh.vertices[(3 * 7 + 3) * 7 + 3] = {3, 3, 3.7};
    EXPECT_THAT(cloud::cloud_from_tets(mesh).warnings, ElementsAre(HasSubstr("spacings apart; expected at least 0.5")));
}

TEST(FromTets, RefusesMoreParticlesThanNodes)
{
    EXPECT_THROW(cloud::cloud_from_tets(ball(), {9262}), InputError);
    EXPECT_THROW(cloud::cloud_from_tets(ball(), {0}), InputError);
}

} // namespace
} // namespace corticle
