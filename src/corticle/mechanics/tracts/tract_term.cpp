// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tracts/tract_term.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::tracts
{

namespace
{

// What the history holds of every tract.
constexpr std::string_view rest_name = "tracts.rest_mm";
constexpr std::string_view length_name = "tracts.length_mm";

/// Acceleration of the centroid of an end per force on it.
double mobility(const TractEnd& end, std::span<const double> masses)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < end.nodes.size(); ++k)
    {
        sum += end.shares[k] * end.shares[k] / masses[static_cast<std::size_t>(end.nodes[k])];
    }
    return sum;
}

/// The numbers that a history holds, or those of the start where it is none yet.
const std::vector<double>& found(const mechanics::History& history, std::string_view name,
                                 const std::vector<double>& first)
{
    const auto entry = history.find(name);
    if (entry == history.end())
    {
        return first;
    }
    if (entry->second.size() != first.size())
    {
        throw InputError(
            fmt::format("the state to start from has {} tracts; expected {}", entry->second.size(), first.size()));
    }
    return entry->second;
}

void keep(std::string_view name, const std::vector<double>& values, mechanics::History& history)
{
    const auto entry = history.find(name);
    if (entry == history.end())
    {
        history.emplace(name, values);
    }
    else
    {
        entry->second = values;
    }
}

} // namespace

Vec3 centroid(const TractEnd& end, std::span<const Vec3> x)
{
    Vec3 sum;
    for (std::size_t k = 0; k < end.nodes.size(); ++k)
    {
        sum += end.shares[k] * x[static_cast<std::size_t>(end.nodes[k])];
    }
    return sum;
}

TractTerm::TractTerm(Tracts tracts, std::span<const Vec3> X, std::span<const double> masses,
                     const mechanics::RunClock& clock)
    : tracts_(std::move(tracts)), clock_(clock), states_(tracts_.tracts.size()), centroids_(tracts_.ends.size()),
      end_forces_(tracts_.ends.size())
{
    std::vector<double> stiffness(tracts_.ends.size()); // of all tracts at an end
    for (const Tract& tract : tracts_.tracts)
    {
        const Vec3 way = centroid(tracts_.ends[static_cast<std::size_t>(tract.to)], X) -
                         centroid(tracts_.ends[static_cast<std::size_t>(tract.from)], X);
        first_length_.push_back(norm(way));
        stiffness[static_cast<std::size_t>(tract.from)] += tract.stiffness;
        stiffness[static_cast<std::size_t>(tract.to)] += tract.stiffness;
    }
    // Two ends that move against each other: w² is at most twice the largest k / m.
    for (std::size_t end = 0; end < tracts_.ends.size(); ++end)
    {
        largest_rate_ = std::max(largest_rate_, std::sqrt(2.0 * stiffness[end] * mobility(tracts_.ends[end], masses)));
    }
}

double TractTerm::elongation(const TractState& state) const
{
    const double longer = state.length - state.rest_length;
    return tracts_.push ? longer : std::max(0.0, longer);
}

double TractTerm::ramp(double t) const
{
    return std::clamp((t - clock_.start) / tracts_.ramp_time, 0.0, 1.0);
}

double TractTerm::ramp_rate(double t) const
{
    return t >= clock_.start && t < clock_.start + tracts_.ramp_time ? 1.0 / tracts_.ramp_time : 0.0;
}

void TractTerm::grow(const mechanics::StepContext& context)
{
    const std::vector<double>& rest = found(context.history, rest_name, first_length_);
    const std::vector<double>& length = found(context.history, length_name, first_length_);
    const double time = clock_.at(context.t) - clock_.at(context.t_before);
    const double drawn = ramp(context.t) - ramp(context.t_before);
    const double drawing = ramp_rate(context.t);
    const double pace = clock_.rate(context.t);
    growth_power_ = 0.0;
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
        const Tract& tract = tracts_.tracts[k];
        const double stretch = std::max(0.0, length[k] - rest[k]);
        const double change = drawn * (tract.rest - 1.0) * first_length_[k] - std::expm1(-tract.rate * time) * stretch;
        states_[k].rest_length = rest[k] + change;
        const double longer = elongation(states_[k]);
        const double rate = drawing * (tract.rest - 1.0) * first_length_[k] +
                            tract.rate * pace * std::max(0.0, states_[k].length - states_[k].rest_length);
        growth_power_ -= tract.stiffness * longer * rate;
    }
}

mechanics::Contribution TractTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    for (std::size_t end = 0; end < centroids_.size(); ++end)
    {
        centroids_[end] = centroid(tracts_.ends[end], context.x);
        end_forces_[end] = {};
    }
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
        const Tract& tract = tracts_.tracts[k];
        states_[k].length =
            norm(centroids_[static_cast<std::size_t>(tract.to)] - centroids_[static_cast<std::size_t>(tract.from)]);
    }
    grow(context);
    energy_ = 0.0;
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
        const Tract& tract = tracts_.tracts[k];
        const auto from = static_cast<std::size_t>(tract.from);
        const auto to = static_cast<std::size_t>(tract.to);
        const double longer = elongation(states_[k]);
        states_[k].tension = tract.stiffness * longer;
        energy_ += 0.5 * tract.stiffness * longer * longer;
        const Vec3 pull = states_[k].tension * normalized(centroids_[to] - centroids_[from]);
        end_forces_[from] += pull;
        end_forces_[to] -= pull;
    }
    for (std::size_t end = 0; end < end_forces_.size(); ++end)
    {
        const TractEnd& at = tracts_.ends[end];
        for (std::size_t k = 0; k < at.nodes.size(); ++k)
        {
            forces[static_cast<std::size_t>(at.nodes[k])] += at.shares[k] * end_forces_[end];
        }
    }
    mechanics::Contribution contribution;
    contribution.growth_power = growth_power_;
    contribution.stable_step = dynamics::contact_step(context.cfl, largest_rate_);
    return contribution;
}

void TractTerm::accept(const mechanics::StepContext& /*context*/, mechanics::History& history)
{
    kept_rest_.resize(states_.size());
    kept_length_.resize(states_.size());
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
        kept_rest_[k] = states_[k].rest_length;
        kept_length_[k] = states_[k].length;
    }
    keep(rest_name, kept_rest_, history);
    keep(length_name, kept_length_, history);
}

} // namespace corticle::tracts
