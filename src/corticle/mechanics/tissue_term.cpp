// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tissue_term.hpp"

namespace corticle::mechanics
{

Contribution TissueTerm::add(const StepContext& context, std::span<Vec3> forces)
{
    if (remodelling_)
    {
        remodelling_->begin(context);
    }
    const InternalResponse response = method_->evaluate(context.x, context.t, forces);
    if (response.invalid_at >= 0)
    {
        return {.invalid_at = response.invalid_at};
    }
    response_ = response;
    return {.elastic_energy = std::max(response.elastic_energy, 0.0), // active fibres that shorten store less than none
            .growth_power = response.growth_power,
            .viscous_power = method_->add_viscous_forces(context.x, context.v, forces),
            .stable_step =
                time_step_ > 0.0 ? time_step_ : dynamics::critical_step(context.cfl, spacing_, response.stiffest_rate)};
}

void TissueTerm::show_present(const StepContext& present)
{
    if (remodelling_)
    {
        remodelling_->begin(present);
    }
}

std::vector<NamedEnergy> TissueTerm::energies() const
{
    std::vector<NamedEnergy> all{{"elastic", response_.elastic_energy}, {"zero_mode", response_.zero_mode_energy}};
    if (remodelling_)
    {
        all.push_back({"remodelling", remodelling_->released()});
    }
    return all;
}

void TissueTerm::accept(const StepContext& context, History& history)
{
    if (remodelling_)
    {
        remodelling_->accept(context, response_.released, history);
    }
}

std::string TissueTerm::cause_of_short_step(std::span<const Vec3> x) const
{
    return "most compressed: " +
           method_->diagnosis(method_->node_of(std::max<std::int64_t>(response_.smallest_J_at, 0)), x);
}

} // namespace corticle::mechanics
