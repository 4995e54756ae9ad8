// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/kuhn_grid.hpp"

#include "corticle/base/random.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/distance_transform.hpp"
#include "corticle/imaging/homotopic_growth.hpp"
#include "corticle/imaging/marching_tetrahedra.hpp"
#include "imaging/label_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace corticle
{

namespace
{

imaging::VoxelGrid small_grid(std::int64_t length)
{
    return {{length, length, length}, {Mat3::diagonal(0.5, 0.8, 1.2), {}}};
}

/// Voxels whose place relative to the middle of the grid, in voxels, the function takes.
imaging::Mask mask_of(const imaging::VoxelGrid& grid, const std::function<bool(const Vec3&)>& inside)
{
    imaging::Mask mask(static_cast<std::size_t>(grid.count()));
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        const auto c = grid.coordinates(voxel);
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] = static_cast<double>(c[axis]) - 0.5 * static_cast<double>(grid.size[axis] - 1);
        }
        mask[voxel] = inside(p) && !grid.is_outermost(voxel) ? 1 : 0;
    }
    return mask;
}

imaging::Mask random_mask(const imaging::VoxelGrid& grid, double share, std::uint64_t seed)
{
    std::uint64_t counter = 0;
    return mask_of(grid, [&](const Vec3&) { return hash_uniform(seed, counter++) < share; });
}

std::int64_t euler_characteristic_of(const TriangleMesh& mesh)
{
    return static_cast<std::int64_t>(mesh.vertices.size()) - static_cast<std::int64_t>(mesh.triangles.size()) / 2;
}

} // namespace

TEST(KuhnGrid, EulerCharacteristicOfKnownBodies)
{
    const imaging::VoxelGrid grid = small_grid(24);
    const auto ball = [](const Vec3& p) { return norm(p) < 8.0; };
    const auto shell = [](const Vec3& p) { return norm(p) < 8.0 && norm(p) > 4.0; };
    const auto torus = [](const Vec3& p) { return ring_distance(p, 7.0) < 2.5; };
    const auto two_balls = [](const Vec3& p) { return norm(p - Vec3{5, 0, 0}) < 3.0 || norm(p + Vec3{5, 0, 0}) < 3.0; };
    EXPECT_EQ(imaging::euler_characteristic(grid, mask_of(grid, ball)), 1);
    EXPECT_EQ(imaging::euler_characteristic(grid, mask_of(grid, shell)), 2);
    EXPECT_EQ(imaging::euler_characteristic(grid, mask_of(grid, torus)), 0);
    EXPECT_EQ(imaging::euler_characteristic(grid, mask_of(grid, two_balls)), 2);
    EXPECT_EQ(imaging::kuhn_components(grid, mask_of(grid, two_balls), 1).sizes.size(), 3U);
    EXPECT_EQ(imaging::kuhn_components(grid, mask_of(grid, shell), 0).sizes.size(), 3U); // outside and cavity
}

TEST(KuhnGrid, SimpleVoxelsKeepTheEulerCharacteristic)
{
    const imaging::VoxelGrid grid = small_grid(5);
    const auto offsets = imaging::kuhn_offsets(grid);
    const std::int64_t middle = grid.index(2, 2, 2);
    int simple = 0;
    int changed = 0;
    for (unsigned set = 0; set < 1U << imaging::kuhn_neighbors; ++set)
    {
        imaging::Mask mask(static_cast<std::size_t>(grid.count()), 0);
        for (int k = 0; k < imaging::kuhn_neighbors; ++k)
        {
            mask[middle + offsets[k]] = set >> k & 1U;
        }
        const std::int64_t without = imaging::euler_characteristic(grid, mask);
        mask[middle] = 1;
        const std::int64_t with = imaging::euler_characteristic(grid, mask);
        EXPECT_TRUE(!imaging::is_simple(set) || with == without) << set;
        // Inside and outside obey the same rule.
        EXPECT_EQ(imaging::is_simple(set), imaging::is_simple(~set & ((1U << imaging::kuhn_neighbors) - 1))) << set;
        simple += imaging::is_simple(set) ? 1 : 0;
        changed += with != without ? 1 : 0;
    }
    EXPECT_FALSE(imaging::is_simple(0));
    EXPECT_GT(simple, 1000);
    EXPECT_GT(changed, 1000);
}

TEST(KuhnGrid, SurfaceHasTheTopologyOfTheMask)
{
    // Noise: every configuration of a cell occurs. Two surfaces of Euler characteristic 2 c bound a body of c.
    const imaging::VoxelGrid grid = small_grid(18);
    for (const double share : {0.1, 0.3, 0.5, 0.7})
    {
        const imaging::Mask mask = random_mask(grid, share, 7);
        const std::vector<float> values(mask.begin(), mask.end());
        const TriangleMesh surface = imaging::marching_tetrahedra(grid, values, 0.5F);
        EXPECT_EQ(euler_characteristic_of(surface), 2 * imaging::euler_characteristic(grid, mask)) << share;
    }
}

TEST(KuhnGrid, GrownAndShrunkBallsAreBalls)
{
    const imaging::VoxelGrid grid = small_grid(16);
    // A body full of holes, handles and loose voxels about a core.
    imaging::Mask mask = random_mask(grid, 0.7, 11);
    const imaging::Components parts = imaging::kuhn_components(grid, mask, 1);
    const auto largest = std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin();
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        mask[voxel] = parts.number[voxel] == largest ? 1 : 0;
    }
    std::vector<float> values(mask.size());
    for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
    {
        values[voxel] = static_cast<float>(hash_uniform(3, voxel));
    }
    const auto outside = imaging::squared_distance_to(grid, mask, 0);
    const auto inside = imaging::squared_distance_to(grid, mask, 1);
    for (const bool grow : {true, false})
    {
        const imaging::Mask ball =
            grow ? imaging::grow_ball(grid, mask, values, outside) : imaging::shrink_ball(grid, mask, values, inside);
        EXPECT_EQ(imaging::euler_characteristic(grid, ball), 1);
        EXPECT_EQ(imaging::kuhn_components(grid, ball, 1).sizes.size(), 2U);
        EXPECT_EQ(imaging::kuhn_components(grid, ball, 0).sizes.size(), 2U);
        const std::vector<float> level(ball.begin(), ball.end());
        const TriangleMesh surface = imaging::marching_tetrahedra(grid, level, 0.5F);
        EXPECT_NO_THROW(geometry::require_valid_surface(surface, "ball"));
        EXPECT_EQ(euler_characteristic_of(surface), 2);
        for (std::size_t voxel = 0; voxel < ball.size(); ++voxel)
        {
            EXPECT_TRUE(grow ? ball[voxel] <= mask[voxel] : ball[voxel] >= mask[voxel]);
        }
    }
}

TEST(MarchingTetrahedra, CutsLinearValuesInAPlane)
{
    const imaging::VoxelGrid grid = small_grid(12);
    std::vector<float> values(static_cast<std::size_t>(grid.count()), 0.0F);
    const Vec3 normal{0.3, 0.2, 0.25};
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        values[voxel] = static_cast<float>(dot(normal, grid.position(voxel)));
    }
    const TriangleMesh surface = imaging::marching_tetrahedra(grid, values, 2.5F);
    ASSERT_GT(surface.triangles.size(), 100U);
    for (const Vec3& p : surface.vertices)
    {
        EXPECT_NEAR(dot(normal, p), 2.5, 1e-5); // the values are single precision
    }
    for (const Triangle& t : surface.triangles)
    {
        const Vec3 area =
            cross(surface.vertices[t[1]] - surface.vertices[t[0]], surface.vertices[t[2]] - surface.vertices[t[0]]);
        EXPECT_LE(dot(area, normal), 1e-9); // towards lower values, which are outside
    }
}

TEST(DistanceTransform, EqualsBruteForce)
{
    const imaging::VoxelGrid grid = small_grid(11);
    const imaging::Mask mask = random_mask(grid, 0.03, 5);
    const std::vector<float> distance = imaging::squared_distance_to(grid, mask, 1);
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::int64_t other = 0; other < grid.count(); ++other)
        {
            nearest = mask[other] == 1 ? std::min(nearest, squared_norm(grid.position(voxel) - grid.position(other)))
                                       : nearest;
        }
        EXPECT_NEAR(distance[voxel], nearest, 1e-4 * (1.0 + nearest));
    }
}

} // namespace corticle
