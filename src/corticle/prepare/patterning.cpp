// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/patterning.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>

namespace corticle::prepare
{

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
    parallel_for(std::ssize(places),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     const Vec3 foot = places[k] + tissue.depth[k] * tissue.normal[k];
                     tissue.regional_rate[k] *= std::max(0.0, 1.0 + options.protomap_amplitude * waves.at(foot));
                 });
}

} // namespace corticle::prepare
