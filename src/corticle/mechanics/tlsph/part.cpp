// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/part.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>

namespace corticle::tlsph
{

namespace
{

/// `values` of [begin, end), at their places among zeros.
template <class Vector>
Vector own_values(const Vector& values, std::int64_t begin, std::int64_t end)
{
    Vector own(values.size());
    std::copy(values.begin() + begin, values.begin() + end, own.begin() + begin);
    return own;
}

/// Places in an array, of which those of [begin, end) are left.
void shift(std::vector<std::int64_t>& places, std::int64_t first, std::int64_t last)
{
    for (std::int64_t& place : places)
    {
        place = std::clamp(place, first, last) - first;
    }
}

template <class Vector>
Vector cut(const Vector& values, std::int64_t begin, std::int64_t end)
{
    return {values.begin() + begin, values.begin() + end};
}

/// The pairs of particles [begin, end), which are those of whole blocks.
PairBlocks own_pairs(const PairBlocks& all, std::int64_t begin, std::int64_t end)
{
    PairBlocks own{all.block_size, all.begin, all.enriched_end, {}, {}, all.table_begin, {}};
    const std::int64_t first = all.begin[begin];
    const std::int64_t last = all.begin[end];
    own.place = cut(all.place, first, last);
    own.weight = cut(all.weight, first, last);
    shift(own.begin, first, last);
    shift(own.enriched_end, first, last);
    const std::int64_t first_row = all.table_begin[block_count(begin, all.block_size)];
    const std::int64_t last_row = all.table_begin[block_count(end, all.block_size)];
    own.table = cut(all.table, first_row, last_row);
    shift(own.table_begin, first_row, last_row);
    return own;
}

/// Keeps the fits of groups of own particles, and places for products of ghosts.
void keep_fits(const EnrichedGradients& all, const PairBlocks& own_pairs, std::int64_t begin, std::int64_t end,
               EnrichedGradients& own)
{
    own.group.assign(all.group.size(), -1);
    std::int32_t groups = 0;
    for (std::int64_t number = block_count(begin, wide_lanes); number < block_count(end, wide_lanes); ++number)
    {
        if (all.group[number] >= 0)
        {
            own.group[number] = groups++;
            own.fits.push_back(all.fits[all.group[number]]);
        }
    }
    for (const std::int32_t j : own_pairs.table)
    {
        const std::int64_t number = j / wide_lanes;
        if (all.group[number] >= 0 && own.group[number] < 0)
        {
            own.group[number] = groups++;
        }
    }
}

} // namespace

Particles part_of(const Particles& all, const Partition& partition, int rank)
{
    const std::int64_t begin = partition.begin(rank);
    const std::int64_t end = partition.end(rank);
    Particles own;
    own.X = all.X;
    own.volume = all.volume;
    own.options = all.options;
    own.spacing = all.spacing;
    own.pairs = own_pairs(all.pairs, begin, end);
    own.correction = own_values(all.correction, begin, end);
    own.weighted_sum = own_values(all.weighted_sum, begin, end);
    own.enriched.reach = all.enriched.reach;
    keep_fits(all.enriched, own.pairs, begin, end, own.enriched);
    return own;
}

} // namespace corticle::tlsph
