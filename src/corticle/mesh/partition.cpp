// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/partition.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <numeric>

namespace corticle
{

namespace
{

/// First blocks of shares that each take as much as costs no more than `limit`, one entry more than shares.
std::vector<std::int64_t> greedy_shares(std::span<const double> costs, double limit)
{
    std::vector<std::int64_t> first{0};
    double cost = 0.0;
    for (std::int64_t block = 0; block < std::ssize(costs); ++block)
    {
        const double own = costs[static_cast<std::size_t>(block)];
        if (cost + own > limit && block > first.back())
        {
            first.push_back(block);
            cost = 0.0;
        }
        cost += own;
    }
    first.push_back(std::ssize(costs));
    return first;
}

/// The least limit that no more shares than ranks need, to a part in a million.
double least_limit(std::span<const double> costs, int ranks)
{
    const double all = std::accumulate(costs.begin(), costs.end(), 0.0);
    double low = std::max(all / ranks, *std::ranges::max_element(costs));
    double high = low + all / ranks;
    constexpr int halvings = 20;
    for (int k = 0; k < halvings; ++k)
    {
        const double middle = 0.5 * (low + high);
        (std::ssize(greedy_shares(costs, middle)) - 1 <= ranks ? high : low) = middle;
    }
    return high;
}

} // namespace

int Partition::owner_of(std::int64_t particle) const
{
    return static_cast<int>(std::ranges::upper_bound(first, particle) - first.begin()) - 1;
}

Partition make_partition(std::int64_t particles, std::span<const double> costs, int ranks)
{
    require_size("costs of blocks", costs.size(), static_cast<std::size_t>(block_count(particles, partition_block)));
    Partition partition{greedy_shares(costs, least_limit(costs, ranks))};
    for (std::int64_t& block : partition.first)
    {
        block = std::min(block * partition_block, particles);
    }
    partition.first.resize(static_cast<std::size_t>(ranks) + 1, particles);
    return partition;
}

} // namespace corticle
