// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace corticle
{

/// One output of the splitmix64 generator (Steele, Lea & Flood 2014) for a counter: the same on every machine.
constexpr std::uint64_t hash_bits(std::uint64_t seed, std::uint64_t counter)
{
    std::uint64_t z = seed * 0xd1342543de82ef95u + (counter + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// A number of [0, 1) for a counter.
constexpr double hash_uniform(std::uint64_t seed, std::uint64_t counter)
{
    return static_cast<double>(hash_bits(seed, counter) >> 11) * 0x1.0p-53;
}

} // namespace corticle
