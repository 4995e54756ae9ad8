// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/pair_blocks.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <limits>

namespace corticle::tlsph
{

namespace
{

constexpr std::int64_t first_block_size = 1024; ///< 512 and 2048 give the same speed within a few per cent

using Tables = std::vector<std::vector<std::int32_t>>;

/// The neighbours of each block, ascending and each once.
Tables tables_of(const Neighbors& neighbors, std::int64_t block_size)
{
    const std::int64_t count = std::ssize(neighbors.begin) - 1;
    const std::int64_t blocks = block_count(count, block_size);
    Tables tables(static_cast<std::size_t>(blocks));
    parallel_for(blocks,
                 [&](std::int64_t block)
                 {
                     const std::int64_t end = std::min(count, (block + 1) * block_size);
                     std::vector<std::int32_t>& table = tables[block];
                     table.assign(neighbors.index.begin() + neighbors.begin[block * block_size],
                                  neighbors.index.begin() + neighbors.begin[end]);
                     std::ranges::sort(table);
                     table.erase(std::unique(table.begin(), table.end()), table.end());
                     table.shrink_to_fit();
                 });
    return tables;
}

bool fits(const Tables& tables)
{
    constexpr std::size_t most = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
    return std::ranges::all_of(tables, [](const auto& table) { return table.size() <= most; });
}

} // namespace

PairBlocks make_pair_blocks(const Neighbors& neighbors)
{
    PairBlocks pairs;
    pairs.block_size = first_block_size;
    Tables tables = tables_of(neighbors, pairs.block_size);
    while (!fits(tables) && pairs.block_size > 1)
    {
        pairs.block_size /= 2;
        tables = tables_of(neighbors, pairs.block_size);
    }
    pairs.begin = neighbors.begin;
    pairs.enriched_end.assign(pairs.begin.begin(), pairs.begin.end() - 1);
    pairs.place.resize(neighbors.index.size());
    pairs.weight.resize(neighbors.index.size());
    pairs.table_begin.assign(1, 0);
    for (const auto& table : tables)
    {
        pairs.table.insert(pairs.table.end(), table.begin(), table.end());
        pairs.table_begin.push_back(std::ssize(pairs.table));
    }
    parallel_for(std::ssize(pairs.begin) - 1,
                 [&](std::int64_t i)
                 {
                     const auto table = pairs.table_of(i / pairs.block_size);
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         const auto at = std::ranges::lower_bound(table, neighbors.index[k]);
                         pairs.place[k] = static_cast<std::uint16_t>(at - table.begin());
                     }
                 });
    return pairs;
}

} // namespace corticle::tlsph
