// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace corticle
{

/// Needed, not only wished, for what takes or returns WideLanes: how those are passed differs between instruction sets,
/// so a function that was not inlined would be called in one way and answer in another.
#define CORTICLE_INLINE [[gnu::always_inline]] inline

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
using WideIntegers = std::int64_t __attribute__((vector_size(64)));
inline constexpr std::int64_t wide_lanes = 8;
/// The same read from or written to memory that holds doubles.
using WideMemory = double __attribute__((vector_size(64), may_alias));

/// What vectors, matrices and the laws of the tissue are made of: one number, or those of eight material points.
template <class Real>
concept RealLike = std::same_as<Real, double> || std::same_as<Real, WideLanes>;

/// Tells the processor that memory at an address will be read soon, which saves the wait where its own guess does not
/// reach: at places that a table names, and at the start of every short stretch of a long array. Any address will do.
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

/// The same number in all lanes.
template <RealLike Real>
CORTICLE_INLINE constexpr Real broadcast(double value)
{
    return Real{} + value;
}

CORTICLE_INLINE double square_root(double a)
{
    return std::sqrt(a);
}
CORTICLE_INLINE WideLanes square_root(const WideLanes& a)
{
    alignas(64) double lanes[wide_lanes];
    *reinterpret_cast<WideMemory*>(lanes) = a;
    for (double& lane : lanes)
    {
        lane = std::sqrt(lane);
    }
    return *reinterpret_cast<const WideMemory*>(lanes);
}

/// The larger of two numbers; the second where one of them is none.
template <RealLike Real>
CORTICLE_INLINE Real larger(const Real& a, const Real& b)
{
    return a > b ? a : b;
}
/// The smaller of two numbers; the second where one of them is none.
template <RealLike Real>
CORTICLE_INLINE Real smaller(const Real& a, const Real& b)
{
    return a < b ? a : b;
}

/// Calls act(lane) where the mask that a comparison gives is set.
template <class Act>
CORTICLE_INLINE void for_lanes(bool mask, Act&& act)
{
    if (mask)
    {
        act(0);
    }
}
template <class Act>
CORTICLE_INLINE void for_lanes(const WideIntegers& mask, Act&& act)
{
    const auto* lanes = reinterpret_cast<const std::int64_t*>(&mask);
    std::int64_t any = 0;
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
/// One lane of a number or of eight.
template <RealLike Real>
CORTICLE_INLINE double& at_lane(Real& real, int lane)
{
    return reinterpret_cast<double*>(&real)[lane];
}

/// a^(-1/3) for a > 0 to round-off: a guess from the exponent bits, then Newton steps r <- r (4 - a r³) / 3.
/// Inlines into vector code, which std::cbrt does not.
template <RealLike Real>
CORTICLE_INLINE Real inverse_cube_root(const Real& a)
{
    using Integer = std::conditional_t<std::same_as<Real, double>, std::int64_t, WideIntegers>;
    // The guess subtracts a third of the upper 32 bits, by a multiplication: no processor divides integers in lanes.
    const Integer upper = std::bit_cast<Integer>(a) >> 32;
    const Integer third = (upper * 0x55555556) & ~std::int64_t{0xffffffff};
    Real r = std::bit_cast<Real>(0x553ef0ff289dd796 - third);
    for (int step = 0; step < 4; ++step)
    {
        r *= (4.0 - a * r * r * r) * (1.0 / 3.0);
    }
    return r;
}

} // namespace corticle
