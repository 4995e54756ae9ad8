// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/regularity.hpp"

#include "corticle/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace corticle
{
namespace
{

constexpr int side = 12;

/// Points of a unit lattice in a cube, and their distances to its faces.
struct LatticeCloud
{
    std::vector<Vec3> positions;
    std::vector<double> depths;
};

LatticeCloud lattice_cloud()
{
    LatticeCloud cloud;
    for (int k = 0; k < side * side * side; ++k)
    {
        const Vec3 X{0.5 + k / (side * side), 0.5 + k / side % side, 0.5 + k % side};
        cloud.positions.push_back(X);
        cloud.depths.push_back(std::min({X.x, X.y, X.z, side - X.x, side - X.y, side - X.z}));
    }
    return cloud;
}

TEST(Regularity, OfALatticeIsPerfect)
{
    const auto [positions, depths] = lattice_cloud();
    const study::Regularity regularity = study::measure_regularity(positions, depths, 1.0, 2.3);
    EXPECT_EQ(regularity.particles, side * side * side);
    EXPECT_DOUBLE_EQ(regularity.closest_pair, 1.0);
    EXPECT_DOUBLE_EQ(regularity.nearest_mean, 1.0);
    EXPECT_DOUBLE_EQ(regularity.nearest_variation, 0.0);
    EXPECT_DOUBLE_EQ(regularity.neighbors_variation, 0.0);
    // Of the 56 lattice points within 2.3 (squares 1, 2, 3, 4, 5), a corner has these in its octant:
    EXPECT_EQ(regularity.fewest_neighbors, 3 + 3 + 1 + 3 + 6);
    EXPECT_LT(regularity.worst_condition, 5.0);
    EXPECT_EQ(regularity.ill_conditioned, 0);
}

TEST(Regularity, OfChanceIsNot)
{
    LatticeCloud cloud = lattice_cloud();
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
        const auto at = [&](std::uint64_t axis) { return side * hash_uniform(6, 3 * i + axis); };
        const Vec3 X{at(0), at(1), at(2)};
        cloud.positions[i] = X;
        cloud.depths[i] = std::min({X.x, X.y, X.z, side - X.x, side - X.y, side - X.z});
    }
    const study::Regularity regularity = study::measure_regularity(cloud.positions, cloud.depths, 1.0, 2.3);
    // Nearest neighbours of a Poisson process: mean Gamma(4/3) (3 / 4 pi)^(1/3), standard deviation 0.36 of it. The
    // faces, beyond which there is nothing, lengthen the mean a little.
    EXPECT_NEAR(regularity.nearest_mean, 0.554, 0.04);
    EXPECT_NEAR(regularity.nearest_variation, 0.363, 0.03);
    // Counts in a ball that holds 51 on the mean.
    EXPECT_NEAR(regularity.neighbors_variation, 1.0 / std::sqrt(51.0), 0.03);
    EXPECT_LT(regularity.closest_pair, 0.2);
}

TEST(Regularity, NamesShapeMatricesThatAreSingular)
{
    // All in one plane.
    std::vector<Vec3> positions;
    for (int k = 0; k < 100; ++k)
    {
        positions.push_back({k / 10 * 1.0, k % 10 * 1.0, 0.0});
    }
    const study::Regularity regularity = study::measure_regularity(positions, std::vector<double>(100, 0.0), 1.0, 2.3);
    EXPECT_EQ(regularity.ill_conditioned, 100);
    EXPECT_GT(regularity.worst_condition, 1e6);
}

} // namespace
} // namespace corticle
