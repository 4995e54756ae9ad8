// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/remodelling.hpp"

#include "corticle/mesh/sizes.hpp"

#include <utility>

namespace corticle::mechanics
{

namespace
{

constexpr std::string_view released_name = "remodelling.released";

/// Made only once, so that later steps allocate nothing.
std::vector<double>& entry_of(History& history, std::string_view name)
{
    const auto found = history.find(name);
    return found != history.end() ? found->second : history[std::string(name)];
}

} // namespace

const double* Remodelling::Variable::found_in(const History& history) const
{
    if (tried.empty())
    {
        return nullptr;
    }
    const auto entry = history.find(name);
    if (entry == history.end())
    {
        return initial.data();
    }
    require_size(name, entry->second.size(), tried.size());
    return entry->second.data();
}

void Remodelling::Variable::keep_in(History& history)
{
    if (!tried.empty())
    {
        std::vector<double>& kept = entry_of(history, name);
        kept.resize(tried.size());
        std::swap(kept, tried);
    }
}

Remodelling::Remodelling(const material::RemodellingOptions& options, std::size_t points, const RunClock& clock)
    : options_(options), clock_(clock)
{
    view_.points = points;
    view_.step.relaxation_share = options.relaxation.share;
    view_.step.growth_ratio = options.stress_growth.volume_ratio;
    view_.step.shrinks = options.stress_growth.shrinks;
    view_.step.has_fibres = options.has_fibres();
    view_.step.fibre_stiffness = options.fibres.stiffness;
    view_.step.fibre_stretch = options.fibres.growth_stretch;
    if (options.relaxation.share > 0.0)
    {
        strain_.initial.assign(6 * points, 0.0); // of the unit tensor: xx, yy and zz come first
        std::fill_n(strain_.initial.begin(), 3 * points, 1.0);
    }
    if (options.stress_growth.rate > 0.0)
    {
        growth_.initial.assign(points, 1.0);
    }
    if (options.has_fibres() && options.fibres.growth_rate > 0.0)
    {
        fibre_length_.initial.assign(points, 1.0);
    }
    for (Variable* variable : {&strain_, &growth_, &fibre_length_})
    {
        variable->tried = variable->initial;
    }
    view_.after = {strain_.target(), growth_.target(), fibre_length_.target()};
}

/// T / mu: rises from 0 at the start.
double Remodelling::tension(double time) const
{
    const material::FibreOptions& fibres = options_.fibres;
    const double share = fibres.ramp > 0.0 ? (time - clock_.at(clock_.start)) / fibres.ramp : 1.0;
    return fibres.active_stress * std::clamp(share, 0.0, 1.0);
}

void Remodelling::begin(const StepContext& context)
{
    const History& history = context.history;
    view_.before = {strain_.found_in(history), growth_.found_in(history), fibre_length_.found_in(history)};
    const auto entry = history.find(released_name);
    released_ = entry == history.end() ? 0.0 : entry->second.at(0);
    const double time = clock_.at(context.t);
    const double time_before = context.t > context.t_before ? clock_.at(context.t_before) : time;
    material::RemodellingStep& step = view_.step;
    step.elapsed = time - time_before;
    step.relaxation = step.elapsed / options_.relaxation.time;
    step.growth = step.elapsed * options_.stress_growth.rate;
    step.fibre_growth = step.elapsed * options_.fibres.growth_rate;
    step.tension_before = tension(time_before);
    step.tension = tension(time);
}

void Remodelling::accept(const StepContext& context, double released, History& history)
{
    for (Variable* variable : {&strain_, &growth_, &fibre_length_})
    {
        variable->keep_in(history);
    }
    entry_of(history, released_name).assign(1, released_ + released);
    view_.after = {strain_.target(), growth_.target(), fibre_length_.target()};
    begin({context.t, context.t, 0.0, context.cfl, context.x, context.v, history});
}

} // namespace corticle::mechanics
