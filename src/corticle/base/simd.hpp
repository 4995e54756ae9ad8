// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <type_traits>

// Eight numbers at once, on the host: vector types of GNU compilers, which those for devices do not know.

namespace corticle
{

/// Builds a function for several instruction sets into one binary; the processor at hand chooses when the program
/// starts.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define CORTICLE_EVERY_ISA [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#define CORTICLE_RUNS(isa) __builtin_cpu_supports(isa)
#else
#define CORTICLE_EVERY_ISA
#define CORTICLE_RUNS(isa) false
#endif

/// Doubles in a register, in the build of such a function that the processor at hand runs.
inline const int register_lanes = CORTICLE_RUNS("x86-64-v4") ? 8 : CORTICLE_RUNS("x86-64-v3") ? 4 : 2;

/// Eight doubles in one SIMD register, or in two or four, as the processor has it. Arithmetic and comparisons go lane
/// by lane; `mask ? a : b` chooses lane by lane.
using WideLanes = double __attribute__((vector_size(64)));
/// Eight integers of 64 bits: the mask that a comparison gives. Compilers differ in what they call these.
using WideIntegers = decltype(WideLanes{} < WideLanes{});
inline constexpr std::int64_t wide_lanes = 8;
/// The same read from or written to memory that holds doubles.
using WideMemory = double __attribute__((vector_size(64), may_alias));

template <>
struct RealTraits<WideLanes>
{
    using Scalar = double;
    using Integer = WideIntegers;

    CORTICLE_INLINE static WideLanes square_root(const WideLanes& a)
    {
        alignas(64) double lanes[wide_lanes];
        *reinterpret_cast<WideMemory*>(lanes) = a;
        for (double& lane : lanes)
        {
            lane = std::sqrt(lane);
        }
        return *reinterpret_cast<const WideMemory*>(lanes);
    }
    CORTICLE_INLINE static double& at_lane(WideLanes& real, int lane) { return reinterpret_cast<double*>(&real)[lane]; }
};

/// Of the mask that a comparison of WideLanes gives.
template <>
struct RealTraits<WideIntegers>
{
    template <class Act>
    CORTICLE_INLINE static void for_lanes(const WideIntegers& mask, Act&& act)
    {
        using Integer = std::remove_cvref_t<decltype(mask[0])>;
        const auto* lanes = reinterpret_cast<const Integer*>(&mask);
        Integer any = 0;
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            any |= lanes[lane];
        }
        for (int lane = 0; any != 0 && lane < wide_lanes; ++lane)
        {
            if (lanes[lane] != 0)
            {
                act(lane);
            }
        }
    }
};

/// Prefetches memory at an address that will be read soon, which saves the wait where the processor's own guess does
/// not reach: at places that a table names, and at the start of every short stretch of a long array. Any address will
/// do.
CORTICLE_INLINE void read_soon(const void* address)
{
    __builtin_prefetch(address);
}

/// Eight of the floats that follow an address, in double precision.
CORTICLE_INLINE WideLanes widen(const float* first)
{
    using Floats = float __attribute__((vector_size(32), aligned(4), may_alias));
    return __builtin_convertvector(*reinterpret_cast<const Floats*>(first), WideLanes);
}

/// A Vec3 and its fourth lane in one SIMD register, or in two, or in four scalars, as the processor has it.
using Lanes = double __attribute__((vector_size(32), may_alias));
CORTICLE_INLINE const Lanes& lanes(const Vec3& v)
{
    return *reinterpret_cast<const Lanes*>(&v.x);
}
CORTICLE_INLINE Lanes& lanes(Vec3& v)
{
    return *reinterpret_cast<Lanes*>(&v.x);
}

} // namespace corticle
