// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/growth_law.hpp"

#include "corticle/base/error.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/model/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::model
{

namespace
{

using material::TissueGrowthAt;

constexpr std::string_view history_name = "growth.by_law"; ///< g_t, g_r, dg_t/dt and dg_r/dt of each node
constexpr std::size_t numbers = 4;

constexpr double sameness = 1e-9;   ///< of growth and 1 at the start: round-off of what a law may calculate
constexpr double first_step = 1e-6; ///< of the length of a run, over which rates at its start are differences

/// Of node i in the history.
TissueGrowthAt kept_growth(std::span<const double> kept, std::size_t i)
{
    const std::span<const double> own = kept.subspan(numbers * i, numbers);
    return {own[0], own[1], own[2], own[3]};
}

/// Of the nodes of a tet.
TissueGrowthAt mean(std::span<const TissueGrowthAt> growth, const std::array<std::int32_t, 4>& nodes)
{
    TissueGrowthAt sum{0.0, 0.0, 0.0, 0.0};
    for (const std::int32_t node : nodes)
    {
        const TissueGrowthAt& at = growth[static_cast<std::size_t>(node)];
        sum.tangential += 0.25 * at.tangential;
        sum.radial += 0.25 * at.radial;
        sum.tangential_rate += 0.25 * at.tangential_rate;
        sum.radial_rate += 0.25 * at.radial_rate;
    }
    return sum;
}

void require_growth(std::span<const TissueGrowthAt> growth)
{
    for (std::size_t i = 0; i < growth.size(); ++i)
    {
        const TissueGrowthAt& at = growth[i];
        if (!(at.tangential > 0.0 && at.radial > 0.0 && std::isfinite(at.tangential * at.radial)))
        {
            throw InputError(
                fmt::format("growth law: got {:g} and {:g} along the normal at particle {}, expected finite "
                            "numbers above 0",
                            at.tangential, at.radial, i));
        }
    }
}

void require_none(std::span<const TissueGrowthAt> growth)
{
    for (std::size_t i = 0; i < growth.size(); ++i)
    {
        const TissueGrowthAt& at = growth[i];
        if (!(std::abs(at.tangential - 1.0) <= sameness && std::abs(at.radial - 1.0) <= sameness))
        {
            throw InputError(
                fmt::format("growth law: got {:.12g} and {:.12g} along the normal at particle {} at the start "
                            "of the run, expected 1: growth is that since the start",
                            at.tangential, at.radial, i));
        }
    }
}

/// Rates of growth from the one to the other, at the other.
void set_rates(std::span<const TissueGrowthAt> from, double elapsed, std::span<TissueGrowthAt> to)
{
    for (std::size_t i = 0; i < to.size(); ++i)
    {
        to[i].tangential_rate = (to[i].tangential - from[i].tangential) / elapsed;
        to[i].radial_rate = (to[i].radial - from[i].radial) / elapsed;
    }
}

} // namespace

void GrowthByLaw::ask(const Simulation& present, double t, std::vector<TissueGrowthAt>& growth) const
{
    growth = present_;
    law_->ask(present, t, growth);
    require_growth(growth);
}

void GrowthByLaw::begin(const Simulation& present, State& state)
{
    present_.assign(model_.cloud.positions.size(), TissueGrowthAt{});
    set(present_, state);
    ask(present, state.t, asked_);
    require_none(asked_);
    const double elapsed = first_step * (present.options().time.end - state.t);
    ask(present, state.t + elapsed, asked_);
    set_rates(present_, elapsed, asked_);
    for (TissueGrowthAt& at : asked_)
    {
        at.tangential = 1.0;
        at.radial = 1.0;
    }
    set(asked_, state);
    accept(state);
}

void GrowthByLaw::show_present(State& state) const
{
    const auto entry = state.history.find(history_name);
    if (entry == state.history.end())
    {
        throw InputError("the state to start from is that of a run without a growth law; expected one with it");
    }
    const std::vector<double>& kept = entry->second;
    require_size(history_name, kept.size(), numbers * model_.cloud.positions.size());
    std::vector<TissueGrowthAt> growth(model_.cloud.positions.size());
    for (std::size_t i = 0; i < growth.size(); ++i)
    {
        growth[i] = kept_growth(kept, i);
    }
    set(growth, state);
}

void GrowthByLaw::grow(const Simulation& present, double t, State& state)
{
    present_ = state.nodes.by_law;
    ask(present, t, asked_);
    set_rates(present_, t - state.t, asked_);
    set(asked_, state);
}

void GrowthByLaw::accept(State& state) const
{
    const std::vector<TissueGrowthAt>& growth = state.nodes.by_law;
    std::vector<double>& kept = state.history[std::string(history_name)];
    kept.clear();
    for (const TissueGrowthAt& at : growth)
    {
        kept.insert(kept.end(), {at.tangential, at.radial, at.tangential_rate, at.radial_rate});
    }
}

void GrowthByLaw::set(std::span<const TissueGrowthAt> growth, State& state) const
{
    state.nodes.by_law.assign(growth.begin(), growth.end());
    if (model_.fem)
    {
        const auto& tets = model_.fem->elements.tets;
        state.elements.by_law.resize(tets.size());
        std::ranges::transform(tets, state.elements.by_law.begin(), [&](const auto& tet) { return mean(growth, tet); });
    }
}

bool GrowthByLaw::is_in(const mechanics::History& history)
{
    return history.contains(history_name);
}

void GrowthByLaw::forget(State& state)
{
    state.nodes.by_law.clear();
    state.elements.by_law.clear();
    if (const auto entry = state.history.find(history_name); entry != state.history.end())
    {
        state.history.erase(entry);
    }
}

double GrowthByLaw::mean_rate(const State& state) const
{
    const std::vector<double>& kept = state.history.find(history_name)->second;
    double volume = 0.0;
    double rate = 0.0;
    for (std::size_t i = 0; i < model_.cloud.volumes.size(); ++i)
    {
        const TissueGrowthAt at = kept_growth(kept, i);
        const double grown = model_.cloud.volumes[i] * at.tangential * at.tangential * at.radial;
        volume += grown;
        rate += grown * (2.0 * at.tangential_rate / at.tangential + at.radial_rate / at.radial);
    }
    return rate / (3.0 * volume);
}

} // namespace corticle::model
