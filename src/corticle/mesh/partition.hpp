// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Particles of which a rank owns all or none: sums are taken over blocks of at most as many, whose size divides this.
inline constexpr std::int64_t partition_block = 1024;

/// Which particles each rank owns: consecutive ones, which lie close together as they are ordered along a curve.
struct Partition
{
    std::vector<std::int64_t> first; ///< particle of each rank; ranks + 1 entries

    int ranks() const { return static_cast<int>(first.size()) - 1; }
    int owner_of(std::int64_t particle) const;
    std::int64_t begin(int rank) const { return first[static_cast<std::size_t>(rank)]; }
    std::int64_t end(int rank) const { return first[static_cast<std::size_t>(rank) + 1]; }
};

/// Whole blocks for every rank, so that the dearest share costs as little as it can. Where there are fewer blocks than
/// ranks some own none.
/// @param costs  of each block of partition_block particles
Partition make_partition(std::int64_t particles, std::span<const double> costs, int ranks);

} // namespace corticle
