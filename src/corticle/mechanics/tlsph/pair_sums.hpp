// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/simd.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"
#include "corticle/mechanics/tlsph/pair_law.hpp"

#include <algorithm>
#include <vector>

// The innermost loop of the program.

namespace corticle::tlsph
{

/// Scratch memory: what the particles that a block reads contribute.
struct BlockTerms
{
    std::vector<PairTerms> linear;
    std::vector<ProductTerms> products; ///< where they are needed
};

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

/// The numbers of a sum in registers, `width` to each of its terms.
template <int lanes, class Terms>
inline constexpr std::size_t registers_of = sizeof(Terms) / sizeof(typename Register<lanes>::Type);

/// sum_j w_ij terms_j over pairs `begin` to `end`, added to `sum`. @param terms  arrays of terms of the same particles
template <int lanes, class... Terms>
CORTICLE_INLINE void add_pairs(const PairBlocks& pairs, std::int64_t begin, std::int64_t end, const Terms*... terms,
                               Terms&... sum)
{
    using Part = typename Register<lanes>::Type;
    constexpr std::size_t width = (registers_of<lanes, Terms> + ...);
    // Eight registers of sums: each waits only for its own last addition.
    constexpr std::size_t stride = std::max<std::size_t>(8 / width, 1);
    Part sums[stride][width]{};
    const std::uint16_t* const place = pairs.place.data();
    const float* const weight = pairs.weight.data();
    const auto add_one = [&]<class Term>(std::size_t s, std::size_t& first, double w, const Term& term)
    {
        const auto* part = reinterpret_cast<const Part*>(&term);
        asm("" : "+r"(part)); // in one register: an addition that also adds up an address takes two operations
        for (std::size_t p = 0; p < registers_of<lanes, Term>; ++p)
        {
            sums[s][first + p] += w * part[p];
        }
        first += registers_of<lanes, Term>;
    };
    const auto add = [&](std::size_t s, double w, std::uint16_t at)
    {
        std::size_t first = 0;
        (add_one(s, first, w, terms[at]), ...);
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
            add(m % stride, w[m], place[k + static_cast<std::int64_t>(m)]);
        }
    }
    for (; k < end; ++k)
    {
        add(0, static_cast<double>(weight[k]), place[k]);
    }
    std::size_t first = 0;
    const auto take = [&]<class Term>(Term& result)
    {
        auto* part = reinterpret_cast<Part*>(&result);
        for (std::size_t p = 0; p < registers_of<lanes, Term>; ++p)
        {
            const std::size_t q = first + p;
            if constexpr (stride == 4)
            {
                part[p] += (sums[0][q] + sums[1][q]) + (sums[2][q] + sums[3][q]);
            }
            else if constexpr (stride == 2)
            {
                part[p] += sums[0][q] + sums[1][q];
            }
            else
            {
                part[p] += sums[0][q];
            }
        }
        first += registers_of<lanes, Term>;
    };
    (take(sum), ...);
}

/// The same, with the registers of the processor at hand.
template <class... Terms>
CORTICLE_INLINE void add_terms(const PairBlocks& pairs, std::int64_t begin, std::int64_t end, const Terms*... terms,
                               Terms&... sum)
{
    switch (register_lanes)
    {
    case 8:
        return add_pairs<8, Terms...>(pairs, begin, end, terms..., sum...);
    case 4:
        return add_pairs<4, Terms...>(pairs, begin, end, terms..., sum...);
    default:
        return add_pairs<2, Terms...>(pairs, begin, end, terms..., sum...);
    }
}

/// sum_j w_ij terms_j over the neighbours j of particle i.
/// @param terms  of the particles in the table of the block of i
CORTICLE_INLINE void sum_terms(const PairBlocks& pairs, std::int64_t i, const BlockTerms& terms, PairTerms& sum)
{
    sum = {};
    add_terms<PairTerms>(pairs, pairs.begin[i], pairs.begin[i + 1], terms.linear.data(), sum);
}

/// The same with the products of the neighbours before pair `end`; the others have none.
CORTICLE_INLINE void sum_terms(const PairBlocks& pairs, std::int64_t i, std::int64_t end, const BlockTerms& terms,
                               EnrichedTerms& sum)
{
    sum = {};
    add_terms<PairTerms, ProductTerms>(pairs, pairs.begin[i], end, terms.linear.data(), terms.products.data(),
                                       sum.linear, sum.products);
    add_terms<PairTerms>(pairs, end, pairs.begin[i + 1], terms.linear.data(), sum.linear);
}

} // namespace corticle::tlsph
