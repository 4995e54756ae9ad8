// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/skull.hpp"

#include "corticle/base/box.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace corticle::boundary
{

namespace
{

constexpr std::string_view position_name = "skull.position";
constexpr std::string_view velocity_name = "skull.velocity";

void pack(std::span<const Vec3> vectors, std::string_view name, mechanics::History& history)
{
    auto found = history.find(name);
    found = found != history.end() ? found : history.emplace(name, std::vector<double>()).first;
    found->second.resize(3 * vectors.size());
    for (std::size_t k = 0; k < vectors.size(); ++k)
    {
        found->second[3 * k] = vectors[k].x;
        found->second[3 * k + 1] = vectors[k].y;
        found->second[3 * k + 2] = vectors[k].z;
    }
}

/// @return whether the history has as many
bool unpack(const mechanics::History& history, std::string_view name, std::span<Vec3> vectors)
{
    const auto found = history.find(name);
    if (found == history.end() || found->second.size() != 3 * vectors.size())
    {
        return false;
    }
    for (std::size_t k = 0; k < vectors.size(); ++k)
    {
        vectors[k] = {found->second[3 * k], found->second[3 * k + 1], found->second[3 * k + 2]};
    }
    return true;
}

} // namespace

double SkullGrowth::scale(double t) const
{
    const auto after = std::ranges::upper_bound(times_, t);
    if (times_.empty() || after == times_.begin())
    {
        return times_.empty() ? 1.0 : scales_.front();
    }
    if (after == times_.end())
    {
        return scales_.back();
    }
    const auto k = static_cast<std::size_t>(after - times_.begin());
    return scales_[k - 1] + (scales_[k] - scales_[k - 1]) * (t - times_[k - 1]) / (times_[k] - times_[k - 1]);
}

double SkullGrowth::rate(double t) const
{
    const auto after = std::ranges::upper_bound(times_, t);
    if (after == times_.begin() || after == times_.end())
    {
        return 0.0;
    }
    const auto k = static_cast<std::size_t>(after - times_.begin());
    return (scales_[k] - scales_[k - 1]) / (times_[k] - times_[k - 1]);
}

Skull::Skull(const TriangleMesh& surface, const BoundaryOptions& options, double mass, double start)
    : triangles_(surface.triangles), rest_(surface.vertices), centre_(bounding_box(surface.vertices).center()),
      growth_(options.times, options.scales), is_elastic_(options.kind == SkullKind::elastic), mass_(mass),
      spring_(vertex_areas(surface.vertices, surface.triangles))
{
    for (double& stiffness : spring_)
    {
        stiffness *= options.stiffness;
    }
    rate_ = 2.0 * std::sqrt(std::accumulate(spring_.begin(), spring_.end(), 0.0) /
                            (mass_ * static_cast<double>(spring_.size())));
    accepted_.x.resize(rest_.size());
    accepted_.v.resize(rest_.size());
    accepted_.force.resize(rest_.size());
    for (std::size_t k = 0; k < rest_.size(); ++k)
    {
        accepted_.x[k] = target(k, start);
    }
    trial_ = accepted_;
}

/// Where its growth says that a vertex is.
Vec3 Skull::target(std::size_t vertex, double t) const
{
    return centre_ + growth_.scale(t) * (rest_[vertex] - centre_);
}

Vec3 Skull::target_rate(std::size_t vertex, double t) const
{
    return growth_.rate(t) * (rest_[vertex] - centre_);
}

void Skull::propose(const dynamics::StepPlan& plan, std::span<Vec3> ways)
{
    const double decay = std::exp(-rate_ * plan.dt);
    for (std::size_t k = 0; k < rest_.size(); ++k)
    {
        ways[k] = is_elastic_ ? plan.dt * decay * (accepted_.v[k] + (plan.dt / mass_) * accepted_.force[k])
                              : target(k, plan.t) - accepted_.x[k];
    }
}

void Skull::move(std::span<const Vec3> ways, double dt)
{
    for (std::size_t k = 0; k < rest_.size(); ++k)
    {
        trial_.x[k] = accepted_.x[k] + ways[k];
        trial_.v[k] = is_elastic_ ? ways[k] / dt : Vec3{};
    }
}

void Skull::begin(const mechanics::StepContext& context)
{
    if (context.dt == 0.0)
    {
        if (unpack(context.history, position_name, accepted_.x))
        {
            unpack(context.history, velocity_name, accepted_.v);
        }
        trial_.x = accepted_.x;
        trial_.v = accepted_.v;
    }
    spring_energy_ = 0.0;
    for (std::size_t k = 0; k < rest_.size(); ++k)
    {
        trial_.force[k] = {};
        if (is_elastic_)
        {
            const Vec3 stretch = trial_.x[k] - target(k, context.t);
            trial_.force[k] = -spring_[k] * stretch;
            spring_energy_ += 0.5 * spring_[k] * squared_norm(stretch);
        }
    }
}

double Skull::kinetic_energy() const
{
    double sum = 0.0;
    for (const Vec3& v : trial_.v)
    {
        sum += 0.5 * mass_ * squared_norm(v);
    }
    return sum;
}

mechanics::Contribution Skull::finish(const mechanics::StepContext& context)
{
    if (context.dt == 0.0)
    {
        accepted_.force = trial_.force;
    }
    mechanics::Contribution contribution;
    for (std::size_t k = 0; k < rest_.size(); ++k)
    {
        const Vec3 rate = target_rate(k, context.t);
        contribution.growth_power -=
            is_elastic_ ? spring_[k] * dot(trial_.x[k] - target(k, context.t), rate) : dot(trial_.force[k], rate);
    }
    if (is_elastic_)
    {
        contribution.viscous_power = 2.0 * rate_ * kinetic_energy();
        contribution.stable_step = dynamics::contact_step(context.cfl, std::sqrt(std::ranges::max(spring_) / mass_));
    }
    return contribution;
}

void Skull::accept(mechanics::History& history)
{
    std::swap(accepted_, trial_);
    trial_ = accepted_;
    pack(accepted_.x, position_name, history);
    pack(accepted_.v, velocity_name, history);
}

} // namespace corticle::boundary
