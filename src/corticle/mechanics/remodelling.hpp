// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/clock.hpp"
#include "corticle/material/remodelling_view.hpp"
#include "corticle/mechanics/force_term.hpp"

namespace corticle::mechanics
{

/// Time in which a run takes place: weeks where there is a clock, growth time otherwise.
struct RunClock
{
    material::GestationalClock clock = material::GestationalClock::none;
    double start = 0.0; ///< [t]

    double at(double t) const
    {
        return clock == material::GestationalClock::none ? t : material::gestational_week(clock, t);
    }
    /// How fast it goes by: weeks per t, or 1.
    double rate(double t) const
    {
        return clock == material::GestationalClock::none
                   ? 1.0
                   : 1.0 / material::growth_time_rate(clock, material::gestational_week(clock, t));
    }
};

/// Histories of the material points: those of the last accepted step, which are in the state, and those that the step
/// being tried would leave.
class Remodelling
{
  public:
    Remodelling(const material::RemodellingOptions& options, std::size_t points, const RunClock& clock);

    /// What follows is tried from `context.t_before`. @throws InputError for a history of another body
    void begin(const StepContext& context);
    /// What was tried last is taken. @param released  energy that it took
    void accept(const StepContext& context, double released, History& history);

    const material::RemodellingView& view() const { return view_; }
    double released() const { return released_; } ///< by all steps so far [mu_w mm³]

  private:
    /// One or more numbers of every point; none where they stay as at the start.
    struct Variable
    {
        std::string_view name;         ///< in the history
        std::vector<double> initial{}; ///< until there is a history
        std::vector<double> tried{};

        const double* found_in(const History& history) const;
        double* target() { return tried.empty() ? nullptr : tried.data(); }
        void keep_in(History& history);
    };
    double tension(double time) const;

    material::RemodellingOptions options_;
    RunClock clock_;
    Variable strain_{"relaxation.strain"};
    Variable growth_{"stress_growth.volume"};
    Variable fibre_length_{"fibres.length"};
    material::RemodellingView view_;
    double released_ = 0.0;
};

} // namespace corticle::mechanics
