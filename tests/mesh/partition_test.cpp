// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/partition.hpp"

#include "base/thread_ranks.hpp"
#include "corticle/base/error.hpp"
#include "corticle/mesh/halo.hpp"
#include "corticle/mesh/replica.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace corticle
{
namespace
{

using testing::ElementsAre;

std::vector<double> random_costs(std::size_t blocks)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> cost(1.0, 3.0);
    std::vector<double> costs(blocks);
    std::ranges::generate(costs, [&] { return cost(random); });
    return costs;
}

TEST(Partition, GivesWholeBlocksOfEqualCost)
{
    const std::vector<double> costs = random_costs(640);
    const std::int64_t particles = 639 * partition_block + 7;
    const Partition partition = make_partition(particles, costs, 8);
    const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / 8.0;
    ASSERT_EQ(partition.ranks(), 8);
    EXPECT_EQ(partition.first.front(), 0);
    EXPECT_EQ(partition.first.back(), particles);
    for (int rank = 0; rank < 8; ++rank)
    {
        EXPECT_EQ(partition.begin(rank) % partition_block, 0);
        const double cost = std::accumulate(costs.begin() + partition.begin(rank) / partition_block,
                                            costs.begin() + block_count(partition.end(rank), partition_block), 0.0);
        EXPECT_LT(cost, mean + 3.0); // no more than the dearest block beside
        EXPECT_EQ(partition.owner_of(partition.begin(rank)), rank);
        EXPECT_EQ(partition.owner_of(partition.end(rank) - 1), rank);
    }
}

TEST(Partition, MoreRanksThanBlocksOwnNothing)
{
    const std::vector<double> costs{1.0, 1.0};
    const Partition partition = make_partition(1500, costs, 4);
    EXPECT_THAT(partition.first, ElementsAre(0, 1024, 1500, 1500, 1500));
    EXPECT_EQ(partition.owner_of(1499), 1);
}

TEST(Partition, WantsACostForEveryBlock)
{
    const std::vector<double> costs{1.0};
    EXPECT_THROW(make_partition(1500, costs, 4), InputError);
}

/// Sums whose bits depend on their order.
double rough(std::int64_t i)
{
    return std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 17));
}

TEST(Share, SumsToTheBitsOfOneRank)
{
    const std::int64_t count = 7 * partition_block + 100;
    const double expected = parallel_sum(count, rough);
    for (const int ranks : {1, 2, 3, 5, 12})
    {
        test::with_ranks(ranks, 2,
                         [&](const Communicator& rank)
                         {
                             const std::vector<double> costs(8, 1.0);
                             const Share share(make_partition(count, costs, ranks), rank);
                             EXPECT_EQ(share.sum(rough), expected);
                         });
    }
}

/// The particles of a line, each of which reads those at most three places from it.
template <class Act>
void each_of_line(std::int64_t i, std::int64_t count, Act&& act)
{
    for (std::int64_t j = std::max<std::int64_t>(0, i - 3); j <= std::min(count - 1, i + 3); ++j)
    {
        if (j != i)
        {
            act(static_cast<std::int32_t>(j));
        }
    }
}

TEST(Halo, BringsWhatIsRead)
{
    const std::int64_t count = 3 * partition_block;
    test::with_ranks(3, 1,
                     [&](const Communicator& rank)
                     {
                         const std::vector<double> costs(3, 1.0);
                         const Share share(make_partition(count, costs, 3), rank);
                         const auto parts = find_halo(share.partition(), rank.rank(),
                                                      [&](std::int64_t i, auto&& act) { each_of_line(i, count, act); });
                         ASSERT_EQ(parts.size(), rank.rank() == 1 ? 2u : 1u);
                         if (rank.rank() == 0)
                         {
                             EXPECT_EQ(parts[0].rank, 1);
                             EXPECT_THAT(parts[0].ours, ElementsAre(1021, 1022, 1023));
                             EXPECT_THAT(parts[0].ghosts, ElementsAre(1024, 1025, 1026));
                         }
                         std::vector<double> values(static_cast<std::size_t>(count), -1.0);
                         share.each([&](std::int64_t i) { values[i] = static_cast<double>(i); });
                         Halo halo(parts, rank, [](std::int32_t) { return std::size_t{1}; });
                         for (int round = 0; round < 2; ++round)
                         {
                             halo.start([&](std::int32_t i, double* at) { return *at = values[i], at + 1; });
                             halo.finish([&](std::int32_t i, const double* at) { return values[i] = *at, at + 1; });
                             share.each([&](std::int64_t i)
                                        { each_of_line(i, count, [&](std::int32_t j) { EXPECT_EQ(values[j], j); }); });
                         }
                     });
}

Vec3 place_of(std::int64_t i)
{
    const auto x = static_cast<double>(i);
    return {x, 2.0 * x, 3.0 * x};
}

TEST(Replica, IsKnownToAllRanks)
{
    const std::int64_t count = 2 * partition_block;
    test::with_ranks(3, 1,
                     [&](const Communicator& rank)
                     {
                         const std::vector<double> costs(2, 1.0);
                         const Share share(make_partition(count, costs, 3), rank);
                         const Replica replica(share, {2000, 5, 1024, 5});
                         EXPECT_THAT(replica.particles(), ElementsAre(5, 1024, 2000));
                         std::vector<Vec3> a(static_cast<std::size_t>(count));
                         std::vector<Vec3> b(static_cast<std::size_t>(count));
                         share.each(
                             [&](std::int64_t i)
                             {
                                 a[i] = place_of(i);
                                 b[i] = 10.0 * a[i];
                             });
                         replica.gather(a, b);
                         for (const std::int32_t i : replica.particles())
                         {
                             EXPECT_EQ(a[i], place_of(i));
                             EXPECT_EQ(b[i], 10.0 * place_of(i));
                         }
                     });
}

} // namespace
} // namespace corticle
