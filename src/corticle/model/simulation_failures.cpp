// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

// What ends a run, in words.

namespace corticle::model
{

namespace
{

// A step of this share of that at rest makes a run of minutes one of weeks; steps of sound folds stay above a
// twentieth.
constexpr double least_step_share = 1e-4;

} // namespace

void Simulation::give_up(const dynamics::Motion& motion, double t, double dt) const
{
    std::string diagnosis;
    for (const auto& term : terms_)
    {
        diagnosis = diagnosis.empty() ? term->diagnosis(trial_sum_.invalid_at, motion.x) : diagnosis;
    }
    throw RunError(fmt::format("inverted at step {}, t = {:.6g}, after {} halvings of the step (dt/T = {:.3g}): {}",
                               state_->steps + 1, t, options_->dynamics.max_halvings, dt / total_time_, diagnosis),
                   {state_->steps + 1, t, trial_sum_.invalid_at});
}

/// Refuses a step so small that the run would not end: a crushed particle, or steps taken back again and again.
void Simulation::require_step(double dt) const
{
    if (dt >= least_step_share * rest_dt_)
    {
        return;
    }
    throw RunError(fmt::format("the step has collapsed at step {}, t = {:.6g}: dt/T = {:.3g}, at rest {:.3g}; {} steps "
                               "taken back so far, the next one {:.3g} of what the stiffness allows; {}",
                               state_->steps + 1, state_->t, dt / total_time_, rest_dt_ / total_time_,
                               state_->rejected_steps, state_->step_scale, cause_of_short_step()),
                   {state_->steps + 1, state_->t});
}

/// What makes the step short, as the term says without which it would be long enough; where no term is, the tissue.
std::string Simulation::cause_of_short_step() const
{
    const std::vector<Vec3>& x = state_->motion.x;
    const auto shortest = static_cast<std::size_t>(std::ranges::min_element(stable_steps_) - stable_steps_.begin());
    double others = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < terms_.size(); ++k)
    {
        others = k == shortest ? others : std::min(others, stable_steps_[k]);
    }
    const bool others_would_do = others * state_->step_scale >= least_step_share * rest_dt_;
    return terms_[others_would_do ? shortest : 0]->cause_of_short_step(x);
}

} // namespace corticle::model
