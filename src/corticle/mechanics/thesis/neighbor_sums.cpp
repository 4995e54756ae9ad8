// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/thesis/neighbor_sums.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace corticle::thesis
{

namespace
{

constexpr std::int32_t none_left = std::numeric_limits<std::int32_t>::max();

using Entries = std::array<std::int64_t, NeighborGroups::size>;

/// Walks the neighbour lists of a group side by side: visit(j, entries), where entries[lane] is the pair with j, or -1.
template <class Visit>
void merge_lists(const tlsph::PairBlocks& pairs, std::int64_t group, Visit&& visit)
{
    constexpr std::int64_t size = NeighborGroups::size;
    const std::int64_t particles = std::ssize(pairs.begin) - 1;
    std::array<std::int64_t, size> at{};
    std::array<std::int64_t, size> end{};
    for (std::int64_t lane = 0; lane < std::min(size, particles - size * group); ++lane)
    {
        at[lane] = pairs.begin[size * group + lane];
        end[lane] = pairs.begin[size * group + lane + 1];
    }
    const auto head = [&](std::int64_t lane)
    { return at[lane] < end[lane] ? pairs.neighbor(size * group + lane, at[lane]) : none_left; };
    for (;;)
    {
        std::int32_t j = none_left;
        for (std::int64_t lane = 0; lane < size; ++lane)
        {
            j = std::min(j, head(lane));
        }
        if (j == none_left)
        {
            return;
        }
        Entries entries{};
        for (std::int64_t lane = 0; lane < size; ++lane)
        {
            entries[lane] = head(lane) == j ? at[lane]++ : -1;
        }
        visit(j, entries);
    }
}

} // namespace

NeighborGroups group_neighbors(const tlsph::PairBlocks& pairs)
{
    constexpr std::int64_t size = NeighborGroups::size;
    const std::int64_t count = (std::ssize(pairs.begin) - 1 + size - 1) / size;
    NeighborGroups groups;
    groups.begin.assign(count + 1, 0);
    parallel_for(count, [&](std::int64_t group)
                 { merge_lists(pairs, group, [&](std::int32_t, const Entries&) { ++groups.begin[group + 1]; }); });
    for (std::int64_t group = 0; group < count; ++group)
    {
        groups.begin[group + 1] += groups.begin[group];
    }
    groups.index.resize(groups.begin[count]);
    groups.weight.assign(size * groups.begin[count], 0.0F);
    parallel_for(count,
                 [&](std::int64_t group)
                 {
                     std::int64_t k = groups.begin[group];
                     merge_lists(pairs, group,
                                 [&](std::int32_t j, const Entries& entries)
                                 {
                                     groups.index[k] = j;
                                     float* const to = groups.weight.data() + NeighborGroups::size * k++;
                                     std::ranges::transform(entries, to,
                                                            [&](std::int64_t entry)
                                                            { return entry >= 0 ? pairs.weight[entry] : 0.0F; });
                                 });
                 });
    return groups;
}

} // namespace corticle::thesis
