// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/base/gather.hpp"
#include "corticle/model/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

// What others see of a simulation.

namespace corticle::model
{

void Simulation::complete()
{
    if (!share_->is_part())
    {
        return;
    }
    dynamics::Motion& motion = state_->motion;
    for (std::vector<Vec3>* vectors : {&motion.x, &motion.v, &motion.force})
    {
        share_->gather_at_root(std::span(*vectors));
    }
    for (const auto& term : terms_)
    {
        term->complete();
    }
    move_layer(state_->t, Share(share_->particles()));
    for (auto& [name, values] : state_->history)
    {
        const auto nodes = static_cast<std::size_t>(share_->particles());
        for (std::size_t first = 0; first + nodes <= values.size(); first += nodes) // numbers of all nodes in turn
        {
            share_->gather_at_root(std::span(values).subspan(first, nodes));
        }
    }
}

/// What comes from outside knows nothing of ranks.
void Simulation::refuse_for_ranks(const char* what) const
{
    if (share_->is_part())
    {
        throw InputError(
            fmt::format("{}: got a simulation of {} ranks, expected one of its own", what, share_->ranks().size()));
    }
}

std::vector<Vec3> Simulation::hand_over_positions()
{
    std::vector<Vec3> positions = std::move(state_->motion.x);
    state_->motion.x = positions;
    return positions;
}

std::vector<mechanics::NamedEnergy> Simulation::energies() const
{
    std::vector<mechanics::NamedEnergy> all;
    for (const auto& term : terms_)
    {
        std::ranges::copy(term->energies(), std::back_inserter(all));
    }
    return all;
}

double Simulation::seconds_of(std::string_view term) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < terms_.size(); ++k)
    {
        sum += terms_[k]->name() == term ? seconds_[k] : 0.0;
    }
    return sum;
}

std::vector<Vec3> Simulation::surface_positions() const
{
    return gather<Vec3>(state_->motion.x, model_->cloud.surface_particles);
}

Vec3 Simulation::place_of_smallest_J() const
{
    return tissue_->method().place_of(std::max<std::int64_t>(internal().smallest_J_at, 0), state_->motion.x);
}

} // namespace corticle::model
