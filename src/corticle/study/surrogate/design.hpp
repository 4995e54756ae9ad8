// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

// Points of the unit cube. A seed gives the same points on every machine.

namespace corticle::fit
{

using Point = std::vector<double>;

/// Variance of a coordinate that may be anywhere in the cube.
inline constexpr double even_variance = 1.0 / 12.0;

/// Numbers one after the other, the same on every machine.
class Random
{
  public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}

    double uniform(); ///< of [0, 1)
    double normal();  ///< mean 0, variance 1
    std::size_t index(std::size_t count);

  private:
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
};

/// A latin hypercube: each coordinate has one point in each of `count` equal parts; of some, the one whose
/// nearest points are farthest apart.
std::vector<Point> latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed);

/// Points that fill the cube ever more evenly, the additive recurrence of Roberts (2018): i a mod 1, a of the
/// generalised golden ratio; shifted by the seed.
std::vector<Point> even_points(std::size_t count, std::size_t dimensions, std::uint64_t seed);

} // namespace corticle::fit
