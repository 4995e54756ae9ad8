// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/force_term.hpp"

#include <memory>
#include <span>
#include <vector>

namespace corticle::model
{

class Simulation;
struct Model;
struct State;

/// Growth that the program does not have, in place of that of the case: a hypothesis about growth.
class GrowthLaw
{
  public:
    GrowthLaw() = default;
    GrowthLaw(const GrowthLaw&) = delete;
    GrowthLaw& operator=(const GrowthLaw&) = delete;
    virtual ~GrowthLaw() = default;

    /// Sets the growth of every node at t, tangential and radial, relative to the start of the run, where it is 1.
    /// Asked for every step that is tried, and for every stage of one.
    /// @param present  the simulation as the last accepted step left it, at t or before it
    /// @param growth   as it is there
    virtual void ask(const Simulation& present, double t, std::span<material::TissueGrowthAt> growth) = 0;
};

/// Growth by such a law in the state of a simulation: that at the last accepted step is in its history, that of the
/// step being tried in its tissue. Rates are those of the mean growth from the one to the other.
class GrowthByLaw
{
  public:
    GrowthByLaw(std::unique_ptr<GrowthLaw> law, const Model& model) : law_(std::move(law)), model_(model) {}

    /// At the start of a run. @throws InputError where the law says something else than 1
    void begin(const Simulation& present, State& state);
    /// Growth as the last accepted step left it. @throws InputError for a history without it, or that of another body
    void show_present(State& state) const;
    /// Growth at t, which is after the present. @throws InputError for growth that is not a number above 0
    void grow(const Simulation& present, double t, State& state);
    /// The step that was tried last is taken.
    void accept(State& state) const;

    /// Whether the history is that of a run with a law.
    static bool is_in(const mechanics::History& history);
    /// No growth by a law from now on.
    static void forget(State& state);
    /// How fast the body would lengthen if its parts grew without holding each other back, d ln L/dt.
    double mean_rate(const State& state) const;

  private:
    void ask(const Simulation& present, double t, std::vector<material::TissueGrowthAt>& growth) const;
    void set(std::span<const material::TissueGrowthAt> growth, State& state) const;

    std::unique_ptr<GrowthLaw> law_;
    const Model& model_;
    std::vector<material::TissueGrowthAt> present_;
    std::vector<material::TissueGrowthAt> asked_;
};

} // namespace corticle::model
