// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/simd.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"
#include "corticle/mechanics/tlsph/pair_law.hpp"

// The innermost loop of the program.

namespace corticle::tlsph
{

/// Doubles in memory, as many as a register holds. Compilers keep wider vectors that go from one round of a loop to the
/// next in memory, which costs ten times the sum: this loop has its width chosen for each instruction set.
template <int lanes>
struct Register;
template <>
struct Register<8>
{
    using Type = double __attribute__((vector_size(64), may_alias));
};
template <>
struct Register<4>
{
    using Type = double __attribute__((vector_size(32), may_alias));
};
template <>
struct Register<2>
{
    using Type = double __attribute__((vector_size(16), may_alias));
};

/// How far ahead of the pair at hand weights and places are asked for: their lists follow one another in memory.
inline constexpr std::int64_t pairs_ahead = 256;

/// sum_j w_ij terms_j over pairs `begin` to `end`.
template <int lanes>
CORTICLE_INLINE void sum_pairs(const PairBlocks& pairs, std::int64_t begin, std::int64_t end, const PairTerms* terms,
                               PairTerms& sum)
{
    using Part = typename Register<lanes>::Type;
    constexpr std::size_t width = sizeof(PairTerms) / sizeof(Part);
    // Eight registers of sums: each waits only for its own last addition.
    constexpr std::size_t stride = 8 / width;
    Part sums[stride][width]{};
    const std::uint16_t* const place = pairs.place.data();
    const float* const weight = pairs.weight.data();
    const auto add = [&](std::size_t s, double w, const PairTerms& term)
    {
        const auto* part = reinterpret_cast<const Part*>(&term);
        asm("" : "+r"(part)); // in one register: an addition that also adds up an address takes two operations
        for (std::size_t p = 0; p < width; ++p)
        {
            sums[s][p] += w * part[p];
        }
    };
    std::int64_t k = begin;
    for (; k + wide_lanes <= end; k += wide_lanes)
    {
        // Through memory: a load spreads a number over all lanes, which is cheaper than to move it out of one.
        alignas(64) double w[wide_lanes];
        read_soon(weight + k + pairs_ahead);
        read_soon(place + k + pairs_ahead);
        *reinterpret_cast<WideMemory*>(w) = widen(weight + k);
        for (std::size_t m = 0; m < wide_lanes; ++m)
        {
            add(m % stride, w[m], terms[place[k + static_cast<std::int64_t>(m)]]);
        }
    }
    for (; k < end; ++k)
    {
        add(0, static_cast<double>(weight[k]), terms[place[k]]);
    }
    auto* result = reinterpret_cast<Part*>(&sum);
    for (std::size_t p = 0; p < width; ++p)
    {
        if constexpr (stride == 4)
        {
            result[p] = (sums[0][p] + sums[1][p]) + (sums[2][p] + sums[3][p]);
        }
        else if constexpr (stride == 2)
        {
            result[p] = sums[0][p] + sums[1][p];
        }
        else
        {
            result[p] = sums[0][p];
        }
    }
}

/// sum_j w_ij terms_j over the neighbours j of particle i.
/// @param terms  of the particles in the table of the block of i
CORTICLE_INLINE void sum_terms(const PairBlocks& pairs, std::int64_t i, const PairTerms* terms, PairTerms& sum)
{
    switch (register_lanes)
    {
    case 8:
        return sum_pairs<8>(pairs, pairs.begin[i], pairs.begin[i + 1], terms, sum);
    case 4:
        return sum_pairs<4>(pairs, pairs.begin[i], pairs.begin[i + 1], terms, sum);
    default:
        return sum_pairs<2>(pairs, pairs.begin[i], pairs.begin[i + 1], terms, sum);
    }
}

} // namespace corticle::tlsph
