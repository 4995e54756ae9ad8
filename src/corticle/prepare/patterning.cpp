// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/patterning.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::prepare
{

namespace
{

/// Multiplies m of every point by a factor at the closest point of the surface, not below 0: a column of cortex grows
/// as one.
template <class FactorAt>
void multiply_growth(std::span<const Vec3> places, material::TissueFields& tissue, FactorAt&& factor_at)
{
    parallel_for(std::ssize(places),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     const Vec3 foot = places[k] + tissue.depth[k] * tissue.normal[k];
                     tissue.regional_rate[k] *= std::max(0.0, factor_at(foot));
                 });
}

} // namespace

void set_growth_times(const PreparationOptions& options, material::GrowthMaps& maps)
{
    if (maps.values.empty())
    {
        return;
    }
    maps.times = options.map.growth_times;
    if (options.time.clock != material::GestationalClock::none)
    {
        std::ranges::transform(maps.times, maps.times.begin(),
                               [&](double week) { return material::growth_time(options.time.clock, week); });
    }
    const bool by_keys = options.tissue.growth_source == material::GrowthSource::keys;
    const bool has_onset = by_keys && options.tissue.growth_law == material::GrowthLaw::linear;
    maps.from = has_onset ? options.tissue.growth_onset : by_keys ? 0.0 : options.time.start;
}

void apply_protomap(const MapOptions& options, std::span<const Vec3> places, material::TissueFields& tissue)
{
    if (options.protomap_amplitude == 0.0)
    {
        return;
    }
    const material::RandomWaves waves(static_cast<std::uint64_t>(options.protomap_seed), options.protomap_wavelength_mm,
                                      options.protomap_wavelength_mm);
    multiply_growth(places, tissue,
                    [&](const Vec3& foot) { return 1.0 + options.protomap_amplitude * waves.at(foot); });
}

double growth_mode(std::size_t mode, const Vec3& direction)
{
    const auto& [x, y, z] = std::array{direction.x, direction.y, direction.z};
    const std::array<double, growth_mode_count> modes{
        std::sqrt(3.0) * y,
        std::sqrt(3.0) * z,
        std::sqrt(3.0) * x,
        std::sqrt(15.0) * x * y,
        std::sqrt(15.0) * y * z,
        std::sqrt(5.0) / 2.0 * (3.0 * z * z - 1.0),
        std::sqrt(15.0) * x * z,
        std::sqrt(15.0) / 2.0 * (x * x - y * y),
        std::sqrt(35.0 / 8.0) * y * (3.0 * x * x - y * y),
        std::sqrt(105.0) * x * y * z,
        std::sqrt(21.0 / 8.0) * y * (5.0 * z * z - 1.0),
        std::sqrt(7.0) / 2.0 * z * (5.0 * z * z - 3.0),
        std::sqrt(21.0 / 8.0) * x * (5.0 * z * z - 1.0),
        std::sqrt(105.0) / 2.0 * z * (x * x - y * y),
        std::sqrt(35.0 / 8.0) * x * (x * x - 3.0 * y * y),
    };
    return modes.at(mode);
}

void apply_modes(std::span<const double> amplitudes, std::span<const Vec3> places, material::TissueFields& tissue)
{
    if (amplitudes.empty())
    {
        return;
    }
    Vec3 moment;
    double volume = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        moment += tissue.volume[k] * places[k];
        volume += tissue.volume[k];
    }
    const Vec3 centre = moment / volume;
    multiply_growth(places, tissue,
                    [&](const Vec3& foot)
                    {
                        const Vec3 direction = normalized(foot - centre);
                        double factor = 1.0;
                        for (std::size_t mode = 0; mode < amplitudes.size(); ++mode)
                        {
                            factor += amplitudes[mode] * growth_mode(mode, direction);
                        }
                        return factor;
                    });
}

} // namespace corticle::prepare
