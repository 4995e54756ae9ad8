// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/base/simd.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"

#include <cstring>

// Sums over many neighbours, eight particles at a time. With hundreds of neighbours each, particles that follow each
// other on the space-filling curve share most of theirs: a record is read once for all eight, and each of its numbers
// is multiplied into eight lanes.

namespace corticle::thesis
{

using FloatOctet = float __attribute__((vector_size(32)));

/// Neighbours of groups of eight consecutive particles.
struct NeighborGroups
{
    static constexpr std::int64_t size = 8;

    std::vector<std::int64_t> begin; ///< groups + 1 entries
    std::vector<std::int32_t> index; ///< neighbours of any particle of the group, ascending
    std::vector<float> weight; ///< eight per index: w_ij of each particle i of the group, 0 where j is none of its

    std::int64_t count() const { return std::ssize(begin) - 1; }
    CORTICLE_INLINE void get_weights(std::int64_t k, FloatOctet& w) const
    {
        std::memcpy(&w, weight.data() + size * k, sizeof w);
    }
};

/// Groups the weighted pairs of particles.
NeighborGroups group_neighbors(const tlsph::PairBlocks& pairs);

/// What a particle adds to the sums of its neighbours: two cache lines.
struct alignas(64) SumRecord
{
    static constexpr int used = 13;
    double value[16];

    CORTICLE_INLINE void set(const Vec3& vector, const Mat3& matrix, double scalar)
    {
        for (int row = 0; row < 3; ++row)
        {
            value[row] = vector[row];
            for (int col = 0; col < 3; ++col)
            {
                value[3 + 3 * col + row] = matrix.column[col][row];
            }
        }
        value[12] = scalar;
    }
};

/// sum_j w_ij times the record of j, of one particle.
struct NeighborSum
{
    Vec3 vector;
    Mat3 matrix;
    double scalar;
};

/// The same of a group.
struct GroupSum
{
    WideLanes value[SumRecord::used];

    CORTICLE_INLINE NeighborSum at(std::int64_t lane) const
    {
        NeighborSum sum{{value[0][lane], value[1][lane], value[2][lane]}, {}, value[12][lane]};
        for (int col = 0; col < 3; ++col)
        {
            sum.matrix.column[col] = {value[3 + 3 * col][lane], value[4 + 3 * col][lane], value[5 + 3 * col][lane]};
        }
        return sum;
    }
};

CORTICLE_INLINE void sum_records(const NeighborGroups& groups, std::int64_t group, const SumRecord* records,
                                 GroupSum& sum)
{
    WideLanes total[SumRecord::used] = {};
    for (std::int64_t k = groups.begin[group]; k < groups.begin[group + 1]; ++k)
    {
        const WideLanes w = widen(groups.weight.data() + NeighborGroups::size * k);
        const double* record = records[groups.index[k]].value;
        for (int c = 0; c < SumRecord::used; ++c)
        {
            total[c] += record[c] * w;
        }
    }
    for (int c = 0; c < SumRecord::used; ++c)
    {
        sum.value[c] = total[c];
    }
}

} // namespace corticle::thesis
