// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace corticle
{

/// Eight doubles in one SIMD register, or in two or four, as the processor has it.
using WideLanes = double __attribute__((vector_size(64), may_alias));
inline constexpr std::int64_t wide_lanes = 8;

#define CORTICLE_INLINE [[gnu::always_inline]] inline

/// Builds a function for several instruction sets into one binary; the processor at hand chooses when the program
/// starts.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define CORTICLE_EVERY_ISA [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define CORTICLE_EVERY_ISA
#endif

/// Eight of the floats that follow an address, in double precision.
CORTICLE_INLINE WideLanes widen(const float* first)
{
    using Floats = float __attribute__((vector_size(32), aligned(4), may_alias));
    return __builtin_convertvector(*reinterpret_cast<const Floats*>(first), WideLanes);
}

} // namespace corticle
