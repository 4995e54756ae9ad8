// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace corticle::material
{

struct TissueFields;

/// Imperfection that folds grow from (keys under [imperfection]).
struct ImperfectionOptions
{
    std::optional<double> amplitude; ///< standard deviation of the growth's relative deviation; not given: see
                                     ///< imperfection_amplitude
    std::int64_t seed = 1;
    double shortest = 4.0; ///< wavelength, in thicknesses of the cortex
    double longest = 10.0; ///< the same
};

/// A smooth random field in space with mean 0 and variance 1: plane waves of random directions and phases, with
/// wavenumbers spread evenly over a band. It depends on the seed and the band alone.
class RandomWaves
{
  public:
    /// @param shortest,longest  wavelengths [mm]
    RandomWaves(std::uint64_t seed, double shortest, double longest);

    double at(const Vec3& X) const;

  private:
    struct Wave
    {
        Vec3 k;       ///< wave vector [1/mm]
        double phase; ///< [rad]
    };
    std::vector<Wave> waves_;
};

/// Multiplies the growth m of every point by 1 + amplitude · waves, taken at the closest point of the surface, so that
/// a column of cortex grows as one and every resolution and method gets the same field.
void apply_imperfection(const RandomWaves& waves, double amplitude, std::span<const Vec3> places, TissueFields& tissue);

} // namespace corticle::material
