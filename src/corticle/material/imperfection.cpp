// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/imperfection.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/material/tissue.hpp"

#include <cmath>
#include <numbers>

namespace corticle::material
{

namespace
{

constexpr std::uint64_t wave_count = 256;

} // namespace

RandomWaves::RandomWaves(std::uint64_t seed, double shortest, double longest)
{
    constexpr double full_turn = 2.0 * std::numbers::pi;
    const double lowest = full_turn / longest;
    const double highest = full_turn / shortest;
    waves_.reserve(wave_count);
    for (std::uint64_t k = 0; k < wave_count; ++k)
    {
        const double wavenumber = lowest + (highest - lowest) * hash_uniform(seed, 4 * k);
        const double z = 2.0 * hash_uniform(seed, 4 * k + 1) - 1.0; // even over the sphere of directions
        const double longitude = full_turn * hash_uniform(seed, 4 * k + 2);
        const double across = std::sqrt(1.0 - z * z);
        const Vec3 direction{across * std::cos(longitude), across * std::sin(longitude), z};
        waves_.push_back({wavenumber * direction, full_turn * hash_uniform(seed, 4 * k + 3)});
    }
}

double RandomWaves::at(const Vec3& X) const
{
    double sum = 0.0;
    for (const Wave& wave : waves_)
    {
        sum += std::cos(dot(wave.k, X) + wave.phase);
    }
    return std::sqrt(2.0 / static_cast<double>(waves_.size())) * sum;
}

void apply_imperfection(const RandomWaves& waves, double amplitude, std::span<const Vec3> places, TissueFields& tissue)
{
    parallel_for(std::ssize(places),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     const Vec3 foot = places[k] + tissue.depth[k] * tissue.normal[k];
                     tissue.regional_rate[k] *= 1.0 + amplitude * waves.at(foot);
                 });
}

} // namespace corticle::material
