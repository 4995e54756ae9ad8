// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

namespace corticle
{

/// Four doubles in one SIMD register (or two, or four scalars, as the processor has it): a Vec3 and its fourth lane.
using Lanes = double __attribute__((vector_size(32), may_alias));

#define CORTICLE_INLINE [[gnu::always_inline]] inline

/// Builds a function for several instruction sets into one binary; the processor at hand chooses when the program
/// starts.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define CORTICLE_EVERY_ISA [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define CORTICLE_EVERY_ISA
#endif

CORTICLE_INLINE const Lanes& lanes(const Vec3& v)
{
    return *reinterpret_cast<const Lanes*>(&v.x);
}
CORTICLE_INLINE Lanes& lanes(Vec3& v)
{
    return *reinterpret_cast<Lanes*>(&v.x);
}

} // namespace corticle
