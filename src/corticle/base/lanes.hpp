// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace corticle
{

/// Marks the functions of the laws: inlined always, and built for a device too where the compiler is one for devices.
/// Inlining is needed, not only wished, for what takes or returns WideLanes (simd.hpp): how those are passed differs
/// between instruction sets, so a function that was not inlined would be called in one way and answer in another.
#if defined(__CUDACC__) || defined(__CUDA__) || defined(__HIP__)
#define CORTICLE_INLINE __attribute__((host, device, always_inline)) inline
#else
#define CORTICLE_INLINE [[gnu::always_inline]] inline
#endif

/// What the laws ask of a kind of number beside its operators. Specialised in simd.hpp for eight numbers at once.
template <class Real>
struct RealTraits
{
    /// What the constants of a formula are written in: a device that computes with float is not to convert to double.
    using Scalar = std::conditional_t<std::floating_point<Real>, Real, double>;
    /// As many bits, for inverse_cube_root.
    using Integer = std::conditional_t<std::same_as<Real, double>, std::int64_t,
                                       std::conditional_t<std::same_as<Real, float>, std::int32_t, void>>;

    CORTICLE_INLINE static Real square_root(const Real& a)
    {
        using std::sqrt;
        return sqrt(a);
    }
    CORTICLE_INLINE static Real& at_lane(Real& real, int /*lane*/) { return real; }
};
template <class Real>
using ScalarOf = typename RealTraits<Real>::Scalar;

/// What vectors, matrices and the laws of the tissue are made of: one number in double or single precision, those of
/// eight material points at once, or one that carries a derivative along.
template <class Real>
concept RealLike = !std::integral<Real> && requires(const Real& a, const Real& b, Real& sum, ScalarOf<Real> s)
{
    {
        a + b
        } -> std::convertible_to<Real>;
    {
        a - b
        } -> std::convertible_to<Real>;
    {
        a* b
        } -> std::convertible_to<Real>;
    {
        a / b
        } -> std::convertible_to<Real>;
    {
        s* a
        } -> std::convertible_to<Real>;
    {
        a + s
        } -> std::convertible_to<Real>;
    {
        -a
        } -> std::convertible_to<Real>;
    sum += a;
    a < s;
};

/// The same number in all lanes.
template <RealLike Real>
CORTICLE_INLINE constexpr Real broadcast(double value)
{
    return Real{} + static_cast<ScalarOf<Real>>(value);
}

template <RealLike Real>
CORTICLE_INLINE Real square_root(const Real& a)
{
    return RealTraits<Real>::square_root(a);
}

/// The larger of two numbers; the second where one of them is NaN.
template <RealLike Real>
CORTICLE_INLINE Real larger(const Real& a, const Real& b)
{
    return a > b ? a : b;
}
/// The smaller of two numbers; the second where one of them is NaN.
template <RealLike Real>
CORTICLE_INLINE Real smaller(const Real& a, const Real& b)
{
    return a < b ? a : b;
}

/// Calls act(lane) where the mask that a comparison gives is set.
template <class Mask, class Act>
CORTICLE_INLINE void for_lanes(const Mask& mask, Act&& act)
{
    if constexpr (std::same_as<Mask, bool>)
    {
        if (mask)
        {
            act(0);
        }
    }
    else
    {
        RealTraits<Mask>::for_lanes(mask, act);
    }
}

/// One lane of a number or of eight.
template <RealLike Real>
CORTICLE_INLINE auto& at_lane(Real& real, int lane)
{
    return RealTraits<Real>::at_lane(real, lane);
}

/// a^(-1/3) for a > 0 to round-off: a guess from the exponent bits, then Newton steps r <- r (4 - a r³) / 3.
/// Inlines into vector code, which std::cbrt does not.
template <RealLike Real>
CORTICLE_INLINE Real inverse_cube_root(const Real& a)
{
    using Scalar = ScalarOf<Real>;
    using Integer = typename RealTraits<Real>::Integer;
    if constexpr (std::same_as<Integer, void>)
    {
        using std::cbrt;
        return Scalar(1.0) / cbrt(a);
    }
    else
    {
        Real r;
        if constexpr (std::same_as<Real, float>)
        {
            const auto bits = __builtin_bit_cast(Integer, a);
            r = __builtin_bit_cast(Real, 0x54a2fa8c - bits / 3);
        }
        else
        {
            // A third of the upper 32 bits is subtracted, by a multiplication: no processor divides integers in lanes.
            const Integer upper = __builtin_bit_cast(Integer, a) >> 32;
            const Integer third = (upper * 0x55555556) & ~std::int64_t{0xffffffff};
            const Integer guess = 0x553ef0ff289dd796 - third;
            r = __builtin_bit_cast(Real, guess);
        }
        for (int step = 0; step < 4; ++step)
        {
            r *= (Scalar(4.0) - a * r * r * r) * Scalar(1.0 / 3.0);
        }
        return r;
    }
}

} // namespace corticle
