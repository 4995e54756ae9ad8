// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/integrator.hpp"
#include "corticle/dynamics/step_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::mechanics
{

/// Variables that a term carries from step to step, by name ("relaxation.strain"): a checkpoint holds them.
using History = std::map<std::string, std::vector<double>, std::less<>>;

/// Where a term is asked for its forces: the end of a step that is tried, or a stage of it.
struct StepContext
{
    double t;                ///< growth time there [-]
    double t_before;         ///< growth time at the beginning of the step [-]
    double dt;               ///< from there to here, in time; 0 at the start of a run
    double cfl;              ///< safety factor of the step [-]
    std::span<const Vec3> x; ///< positions of the nodes [mm]
    std::span<const Vec3> v; ///< velocities of the nodes [mm per unit of time]
    const History& history;  ///< as the last accepted step left it
};

struct NamedEnergy
{
    std::string_view name;
    double value; ///< [mu_w mm³]
};

/// What a term says of its forces besides the forces; what all terms say together is the sum.
struct Contribution
{
    double elastic_energy = 0.0; ///< of the tissue: loading follows it [mu_w mm³]
    double growth_power = 0.0;   ///< dE/dt at fixed positions, per unit of growth time [mu_w mm³]
    double viscous_power = 0.0;  ///< taken from the motion [mu_w mm³ per unit of time]
    double stable_step = std::numeric_limits<double>::infinity(); ///< longest step, in time, the safety factor included
    std::int64_t invalid_at = -1; ///< first node where the state is invalid (inverted, not finite); -1: none

    Contribution& operator+=(const Contribution& other)
    {
        elastic_energy += other.elastic_energy;
        growth_power += other.growth_power;
        viscous_power += other.viscous_power;
        stable_step = std::min(stable_step, other.stable_step);
        invalid_at = invalid_at < 0 ? other.invalid_at : invalid_at;
        return *this;
    }
};

/// What a term took from the motion to keep a limit, such as that surfaces do not cross, or gave to it.
struct TravelTaken
{
    double energy = 0.0;           ///< kinetic, dissipated [mu_w mm³]
    double supplied = 0.0;         ///< kinetic, by what moves nodes from outside [mu_w mm³]
    std::int64_t vertex_steps = 0; ///< displacements it changed

    TravelTaken& operator+=(const TravelTaken& other)
    {
        energy += other.energy;
        supplied += other.supplied;
        vertex_steps += other.vertex_steps;
        return *this;
    }
};

/// Some of the forces on the nodes of a body: the tissue, contact, a skull, gravity. A simulation owns a list of terms;
/// it tries a step, asks all of them, and notifies them when the step is taken.
class ForceTerm
{
  public:
    ForceTerm() = default;
    ForceTerm(const ForceTerm&) = delete;
    ForceTerm& operator=(const ForceTerm&) = delete;
    virtual ~ForceTerm() = default;

    /// As logs and records call it: "tissue".
    virtual std::string_view name() const = 0;

    /// Adds its forces [mu_w mm²], one per node. The tissue, which comes first, sets them. Where the result is invalid
    /// the forces are not used.
    virtual Contribution add(const StepContext& context, std::span<Vec3> forces) = 0;

    /// What it stores at the positions last asked for, by kind.
    virtual std::vector<NamedEnergy> energies() const { return {}; }

    /// Gathers what energies() needs of other ranks. Collective.
    virtual void complete() {}

    /// Whether it takes the forces of all others, as supports do.
    virtual bool comes_last() const { return false; }

    /// Changes the way of nodes in a step that is about to be tried, positions and velocities alike. Terms are called
    /// in the reverse order of their list: contact keeps surfaces apart after all else has moved them.
    /// @param longest  way of a node in this step; a term that lengthens one raises it [mm]
    virtual TravelTaken limit_travel(const dynamics::Motion& /*from*/, const dynamics::StepPlan& /*plan*/,
                                     double& /*longest*/, dynamics::Motion& /*to*/)
    {
        return {};
    }

    /// The step that was tried last is taken: advances what the term carries from step to step.
    virtual void accept(const StepContext& /*context*/, History& /*history*/) {}

    /// What is wrong where `invalid_at` is this node, in words; empty where the term does not know.
    virtual std::string diagnosis(std::int64_t /*node*/, std::span<const Vec3> /*x*/) const { return {}; }

    /// What makes the stable step as short as it is, in words; some force must act.
    virtual std::string cause_of_short_step(std::span<const Vec3> /*x*/) const { return std::string(name()); }
};

} // namespace corticle::mechanics
