// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/loading.hpp"

#include "corticle/material/layer_stability.hpp"
#include "corticle/material/tissue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::dynamics
{

namespace
{

constexpr double slow_from = 0.96;      ///< of the growth at which a flat cortex folds
constexpr double slow_until = 1.12;     ///< a curved cortex, a smooth layer and coarse tets fold late
constexpr double slowing_time = 0.01;   ///< growth time [t] in which the rate follows before folds appear
constexpr double kinetic_share = 1e-3;  ///< kinetic over elastic energy that loading after the onset aims at
constexpr double adjusting_time = 0.03; ///< growth time [t] in which the rate follows then

/// Growth of the cortex over that of the white matter where m = 1.
double relative_growth(const material::TissueOptions& tissue, double t)
{
    const material::GrowthCourse course{tissue.growth_law, tissue.growth_onset, tissue.growth_rate};
    const double f = course.value(t);
    return material::material_point(tissue, 1.0, 1.0, f).growth / material::material_point(tissue, 0.0, 1.0, f).growth;
}

double follow(double rate, double wanted, double part)
{
    return rate + std::min(1.0, part) * (wanted - rate);
}

} // namespace

Loading::Loading(const DynamicsOptions& dynamics, const material::TissueOptions& tissue, double start)
    : dynamics_(dynamics), tissue_(tissue), growth_at_start_(relative_growth(tissue, start)),
      critical_growth_(tissue.growth_source == material::GrowthSource::keys ? material::critical_layer(tissue).growth
                                                                            : std::numeric_limits<double>::infinity())
{
}

bool Loading::is_critical(double t) const
{
    const double share = relative_growth(tissue_, t) / growth_at_start_ / critical_growth_;
    return share > slow_from && share < slow_until;
}

double Loading::next(const LoadedStep& step) const
{
    if (dynamics_.time_step > 0.0)
    {
        return step.rate;
    }
    if (!step.has_folded)
    {
        const double wanted = is_critical(step.t) ? dynamics_.slowest_loading : 1.0;
        return follow(step.rate, wanted, step.growth_step / slowing_time);
    }
    const double aim = kinetic_share * step.elastic_energy;
    const double kinetic = std::max(step.kinetic_energy, std::numeric_limits<double>::min());
    const double wanted = std::clamp(step.rate * std::sqrt(aim / kinetic), 1.0, dynamics_.fastest_loading);
    return follow(step.rate, wanted, step.growth_step / adjusting_time);
}

} // namespace corticle::dynamics
