// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/loading.hpp"
#include "corticle/dynamics/runge_kutta.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/model/model.hpp"
#include "corticle/model/options.hpp"
#include "corticle/model/state.hpp"

#include <memory>
#include <optional>

namespace corticle
{

/// What the parts of the steps took, wall time since the simulation was made [s].
struct StepSeconds
{
    double internal_forces = 0.0;
    double contact = 0.0; ///< search included
};

/// The loop: grow, F, stress, forces, contact, integrate. Steps follow the state; a step that inverts a particle is
/// taken back and halved.
class Simulation
{
  public:
    /// Several simulations may share a model.
    Simulation(std::shared_ptr<const Model> model, SimulationOptions options);

    /// Starts from a state read from a checkpoint (positions, velocities, books).
    void restore(State state);

    /// One accepted step, no farther than growth time `t_stop`.
    /// @throws RunError with the diagnosis (step, t, particle, position, F, J, neighbours) when halving does not help,
    /// or when what the state allows has collapsed to next to nothing
    void step(double t_stop);

    const State& state() const { return *state_; }
    const Model& model() const { return *model_; }
    const SimulationOptions& options() const { return *options_; }
    /// The tissue at the nodes, now.
    Tissue tissue() const { return {options_->tissue, model_->tissue, state_->nodes}; }
    const InternalResponse& internal() const { return internal_; }
    const ContactResponse& contact() const { return contact_response_; }
    double contact_energy() const { return contact_.energy(); } ///< [mu_w mm³]
    const StepSeconds& seconds() const { return seconds_; }
    double total_time() const { return total_time_; }
    /// Step the state allows now, in growth time [-].
    double step_size() const { return critical_dt_ * state_->step_scale * state_->loading_rate / total_time_; }

    std::vector<Mat3> deformation_gradients() const { return solver_->deformation_gradients(state_->motion.x); }
    std::vector<Vec3> surface_positions() const;
    /// Where the particle or tet with the smallest J is now [mm].
    Vec3 place_of_smallest_J() const;

  private:
    void start();
    void move_layer(double t);
    InternalResponse internal_forces(Motion& motion, double t);
    void add_contact(Motion& motion);
    TravelTaken hold_apart(double dt);
    bool evaluate(Motion& motion, double t);
    std::optional<StepEnergies> propose(double t, double dt);
    void note_onset();
    [[noreturn]] void give_up(const Motion& motion, double t, double dt) const;
    void require_step(double dt) const;
    std::string cause_of_short_step() const;

    // Behind pointers, so that what refers to them outlives a move of the simulation.
    std::shared_ptr<const Model> model_;
    std::unique_ptr<const SimulationOptions> options_;
    std::unique_ptr<State> state_;
    std::unique_ptr<Discretization> solver_;
    std::vector<double> mass_;                    ///< density 1 [mm³]
    std::vector<std::int32_t> contact_particles_; ///< of the surface, ascending: neighbours stand near each other
    SurfaceContact contact_;
    double total_time_; ///< T, time of t = 0..1
    double damping_;    ///< gamma
    double rest_dt_;    ///< the step that the body allows at rest
    Loading loading_;
    Motion proposed_;
    InternalResponse internal_;
    ContactResponse contact_response_;
    double viscous_power_ = 0.0; ///< of the discretisation's viscosity
    RungeKutta4 runge_kutta_;
    double tissue_dt_ = 0.0;         ///< step that the tissue allows
    double critical_dt_ = 0.0;       ///< that, or less where contact asks for it
    std::vector<Vec3> displacement_; ///< of the vertices of the surface in the step [mm]
    TravelTaken travel_taken_;       ///< by the step proposed last
    StepSeconds seconds_;
};

} // namespace corticle
