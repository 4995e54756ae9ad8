// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/large_pages.hpp"
#include "corticle/mesh/neighbor_list.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::tlsph
{

/// Weighted pairs of a cloud, cut into blocks of consecutive particles. Every block has a table: the particles that its
/// own ones have for neighbours, some thousand that lie close together. A pair names its neighbour by the place in that
/// table, in 2 bytes, and what the neighbours contribute to a sum is worked out once per block and read from a cache.
struct PairBlocks
{
    std::int64_t block_size = 0;            ///< particles per block
    std::vector<std::int64_t> begin;        ///< first pair of every particle; particles + 1 entries
    std::vector<std::int64_t> enriched_end; ///< past the last pair with an enriched neighbour: those come first
    LargeVector<std::uint16_t> place;       ///< of j in the table of the block of i, one per pair
    LargeVector<float> weight;              ///< w_ij = V_i V_j omega_ij, one per pair, symmetric (see Particles)
    std::vector<std::int64_t> table_begin;  ///< first entry of every block's table; blocks + 1 entries
    std::vector<std::int32_t> table;        ///< particles of the tables, ascending within each

    std::int64_t size(std::int64_t i) const { return begin[i + 1] - begin[i]; }

    /// j of pair k of particle i, begin[i] <= k < begin[i + 1].
    std::int32_t neighbor(std::int64_t i, std::int64_t k) const
    {
        return table[table_begin[i / block_size] + place[k]];
    }

    std::span<const std::int32_t> table_of(std::int64_t block) const
    {
        return std::span(table).subspan(table_begin[block], table_begin[block + 1] - table_begin[block]);
    }
};

/// Cuts into blocks of 1024 particles, or of fewer where a table would not be addressed by 2 bytes. Weights are zero.
PairBlocks make_pair_blocks(const Neighbors& neighbors);

} // namespace corticle::tlsph
