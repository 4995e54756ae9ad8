// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/loading.hpp"
#include "corticle/dynamics/runge_kutta.hpp"
#include "corticle/dynamics/step_plan.hpp"
#include "corticle/mechanics/contact/contact_term.hpp"
#include "corticle/mechanics/tissue_term.hpp"
#include "corticle/mesh/replica.hpp"
#include "corticle/model/growth_law.hpp"
#include "corticle/model/model.hpp"
#include "corticle/model/options.hpp"
#include "corticle/model/state.hpp"

#include <memory>
#include <optional>

namespace corticle::model
{

/// The loop: grow, ask every force term, integrate. Steps follow the state; a step that inverts a particle is taken
/// back and halved.
class Simulation
{
  public:
    /// Several simulations may share a model.
    Simulation(std::shared_ptr<const Model> model, const SimulationOptions& options);
    /// The part of one of several ranks, each of which makes one and takes the same steps with it: all that follows is
    /// collective, and what it says of the whole body is the same on all ranks. Vectors of single nodes are right for
    /// the own ones, those that the own ones read, and those of the surface, and on rank 0 after complete() for all.
    Simulation(std::shared_ptr<const Model> model, const SimulationOptions& options, const Share& share);

    /// One more force on the nodes, from the present state on. What the force throws there leaves it out again.
    void add_term(std::unique_ptr<mechanics::ForceTerm> term);

    /// Growth by this law in place of that of the case, from the start on.
    /// @throws InputError after steps, where there is a law already, and for growth that is not 1 at the start
    void set_growth_law(std::unique_ptr<GrowthLaw> law);

    /// Starts from a state read from a checkpoint. @throws InputError where it is that of another body, or one of the
    /// two grows by a law and the other does not
    void restore(State state);

    /// One accepted step, no farther than growth time `t_stop`.
    /// @throws RunError with the diagnosis (step, t, particle, position, F, J, neighbours) when halving does not help,
    /// or when what the state allows has collapsed to next to nothing
    void step(double t_stop);

    /// The positions in the memory they are in now; the simulation goes on with a copy. For those who look at the
    /// positions without copying them, and want what they see to stay as it is.
    std::vector<Vec3> hand_over_positions();

    /// Brings the whole state to rank 0.
    void complete();

    const Model& model() const { return *model_; }
    const Share& share() const { return *share_; }
    const SimulationOptions& options() const { return *options_; }
    const State& state() const { return *state_; }
    /// The tissue at the nodes, now.
    material::Tissue tissue() const { return {options_->tissue, model_->tissue, state_->nodes}; }
    /// All forces, the tissue's first.
    std::span<const std::unique_ptr<mechanics::ForceTerm>> terms() const { return terms_; }
    /// What all terms store now, by kind [mu_w mm³].
    std::vector<mechanics::NamedEnergy> energies() const;
    const mechanics::InternalResponse& internal() const { return tissue_->response(); }
    /// Null where tissue has no history.
    const mechanics::Remodelling* remodelling() const { return tissue_->remodelling(); }
    contact::ContactResponse contact() const
    {
        return contact_ != nullptr ? contact_->response() : contact::ContactResponse{};
    }
    contact::WallContact wall_contact() const
    {
        return contact_ != nullptr ? contact_->wall_contact() : contact::WallContact{};
    }
    /// Wall time that a term has taken since the simulation was made [s]; 0 where there is no term of this name.
    double seconds_of(std::string_view term) const;
    /// Kinetic energy of the motion against the mean growth of the body, where growth by week tells that; else all of
    /// it [mu_w mm³].
    double relative_kinetic_energy() const { return relative_kinetic_energy_; }
    double total_time() const { return total_time_; }
    /// Step the state allows now, in growth time [-].
    double step_size() const { return now_.stable_step * state_->step_scale * state_->loading_rate / total_time_; }

    std::vector<Mat3> deformation_gradients() const
    {
        return tissue_->method().deformation_gradients(state_->motion.x);
    }
    std::vector<Vec3> surface_positions() const;
    /// Where the particle or tet with the smallest J is now [mm].
    Vec3 place_of_smallest_J() const;

  private:
    void start_moving();
    void start();
    dynamics::Medium medium(double t) const;
    void grow_by_law(double t);
    void move_layer(double t, const Share& share);
    bool evaluate(dynamics::Motion& motion, double t, double dt);
    void refuse_for_ranks(const char* what) const;
    std::optional<dynamics::StepEnergies> advance(const dynamics::StepPlan& plan);
    mechanics::TravelTaken limit_travel(const dynamics::StepPlan& plan, double longest);
    void commit(const dynamics::StepPlan& plan, const dynamics::StepEnergies& energies);
    void note_onset();
    void require_step(double dt) const;
    [[noreturn]] void give_up(const dynamics::Motion& motion, double t, double dt) const;
    std::string cause_of_short_step() const;

    // Behind pointers, so that what refers to them outlives a move of the simulation.
    std::shared_ptr<const Model> model_;
    std::unique_ptr<const SimulationOptions> options_;
    std::unique_ptr<State> state_;
    std::unique_ptr<const Share> share_;
    Replica known_; ///< nodes that terms other than the tissue look at
    Replica held_;  ///< nodes whose forces supports take
    std::vector<std::unique_ptr<mechanics::ForceTerm>> terms_;
    mechanics::TissueTerm* tissue_ = nullptr;       ///< the first of them
    const contact::ContactTerm* contact_ = nullptr; ///< or none
    std::unique_ptr<GrowthByLaw> law_;              ///< or null: growth is the case's
    std::vector<double> seconds_;                   ///< of each term
    std::vector<double> stable_steps_;              ///< of each term at the last evaluation
    const std::vector<double>& mass_;               ///< density 1 [mm³]
    double total_time_;                             ///< T, time of t = 0..1
    double damping_;                                ///< gamma
    Vec3 centre_;                                   ///< of mass, at rest [mm]
    material::PerTissue<double> tissue_volumes_;    ///< reference volumes [mm³]
    double rest_dt_;                                ///< the step that the body allows at rest
    dynamics::Loading loading_;
    dynamics::RungeKutta4 runge_kutta_;
    double relative_kinetic_energy_ = 0.0;
    dynamics::Motion trial_;
    mechanics::TravelTaken trial_travel_; ///< taken from the step that is tried
    mechanics::Contribution now_;         ///< of all terms, at the present state
    mechanics::Contribution trial_sum_;   ///< the same of the step that is tried
};

} // namespace corticle::model
