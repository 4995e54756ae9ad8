// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/neighbor_count_volumes.hpp"

#include "corticle/base/error.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace corticle
{
namespace
{

constexpr int side = 17;         // points a side of a lattice of unit width
constexpr double radius = 3.001; // just above a lattice distance, so that no count hangs on round-off

std::vector<Vec3> lattice()
{
    std::vector<Vec3> points;
    for (int k = 0; k < side * side * side; ++k)
    {
        points.push_back({k / (side * side) * 1.0, k / side % side * 1.0, k % side * 1.0});
    }
    return points;
}

std::size_t at(int x, int y, int z)
{
    return static_cast<std::size_t>((x * side + y) * side + z);
}

/// Lattice points within the radius of one, itself excluded, no further down than `below` along each axis.
int lattice_neighbors(int below_x, int below_y, int below_z)
{
    int count = -1;
    for (int x = -below_x; x <= 3; ++x)
    {
        for (int y = -below_y; y <= 3; ++y)
        {
            for (int z = -below_z; z <= 3; ++z)
            {
                count += x * x + y * y + z * z < radius * radius ? 1 : 0;
            }
        }
    }
    return count;
}

TEST(NeighborCountVolumes, SumToTheVolumeOfTheBody)
{
    const std::vector<double> volumes = prepare::neighbor_count_volumes(lattice(), radius, 4096.0);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 4096.0, 1e-9);
}

TEST(NeighborCountVolumes, AreEvenDeepInsideAndTooLargeAtTheSurface)
{
    const std::vector<double> volumes = prepare::neighbor_count_volumes(lattice(), radius, 4096.0);
    const double deep = volumes[at(8, 8, 8)];
    EXPECT_DOUBLE_EQ(volumes[at(4, 12, 9)], deep);
    EXPECT_LT(deep, 1.0); // what the surface takes too much lacks inside; the exact cell is 1
    // The exact cells of a face, an edge and a corner are a half, a quarter and an eighth of an inner one.
    const int all = lattice_neighbors(3, 3, 3);
    const int face = lattice_neighbors(0, 3, 3);
    const int corner = lattice_neighbors(0, 0, 0);
    EXPECT_DOUBLE_EQ(volumes[at(0, 8, 8)] / deep, static_cast<double>(all) / face);
    EXPECT_DOUBLE_EQ(volumes[at(0, 0, 0)] / deep, static_cast<double>(all) / corner);
    EXPECT_GT(volumes[at(0, 8, 8)] / deep, 1.5);
    EXPECT_GT(volumes[at(0, 0, 0)] / deep, 4.0);
}

TEST(NeighborCountVolumes, RefuseAParticleWithoutNeighbours)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
    try
    {
        prepare::neighbor_count_volumes(points, 2.0, 1.0);
        FAIL() << "no error";
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("particle 2 at (5, 0, 0)"), std::string::npos) << error.what();
    }
    EXPECT_THROW(prepare::neighbor_count_volumes(points, 0.0, 1.0), InputError);
    EXPECT_THROW(prepare::neighbor_count_volumes(points, 10.0, -1.0), InputError);
    EXPECT_TRUE(prepare::neighbor_count_volumes({}, 1.0, 1.0).empty());
}

} // namespace
} // namespace corticle
