// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/stopwatch.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/model/discretization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace corticle
{

namespace
{

constexpr std::int64_t onset_interval = 10; ///< steps between looks at the sphere index
constexpr double onset_rise = 0.01;
constexpr double rounding = 1e-12;     ///< of t: a remainder this small is no step of its own
constexpr double step_recovery = 1.05; ///< factor by which a halved step grows back, per step
// A step of this share of that at rest makes a run of minutes one of weeks; steps of sound folds stay above a
// twentieth.
constexpr double least_step_share = 1e-4;

template <class T>
std::vector<T> gather(const std::vector<T>& values, std::span<const std::int32_t> at)
{
    std::vector<T> result;
    result.reserve(at.size());
    for (const std::int32_t k : at)
    {
        result.push_back(values[static_cast<std::size_t>(k)]);
    }
    return result;
}

double loading_time(const Model& model, const SimulationOptions& options)
{
    double volume = 0.0;
    for (const double V : model.cloud.volumes)
    {
        volume += V;
    }
    const double radius = std::cbrt(3.0 * volume / (4.0 * std::numbers::pi));
    return options.dynamics.loading_time * radius / wave_speed(options.tissue);
}

/// The body at rest as its growth begins.
State starting_state(const Model& model, const SimulationOptions& options)
{
    const ReferenceSize size = cortex_size(options);
    State state;
    state.t = options.time.start;
    state.motion.x = model.cloud.positions;
    state.motion.v.resize(model.cloud.positions.size());
    state.nodes = start_tissue(model.tissue, options.tissue, size, state.t);
    if (model.fem)
    {
        state.elements = start_tissue(model.fem->tissue, options.tissue, size, state.t);
    }
    return state;
}

std::vector<std::int32_t> sorted(std::vector<std::int32_t> numbers)
{
    std::ranges::sort(numbers);
    return numbers;
}

/// Contact of the body's surface, whose vertices are numbered as in `particles`.
SurfaceContact contact_of(const Model& model, std::span<const std::int32_t> particles,
                          const std::vector<double>& masses, const TissueOptions& tissue, const ContactOptions& options)
{
    const auto vertex_of = [&](std::int32_t vertex)
    {
        const std::int32_t particle = model.cloud.surface_particles[static_cast<std::size_t>(vertex)];
        return static_cast<std::int32_t>(std::ranges::lower_bound(particles, particle) - particles.begin());
    };
    std::vector<Triangle> triangles;
    triangles.reserve(model.cloud.surface_triangles.size());
    for (const auto& [a, b, c] : model.cloud.surface_triangles)
    {
        triangles.push_back({vertex_of(a), vertex_of(b), vertex_of(c)});
    }
    std::vector<Vec3> rest(particles.size());
    for (std::int32_t vertex = 0; vertex < std::ssize(rest); ++vertex)
    {
        rest[static_cast<std::size_t>(vertex_of(vertex))] = model.surface.vertices[static_cast<std::size_t>(vertex)];
    }
    const double frequency = wave_speed(tissue) / model.cloud.spacing;
    return {triangles, rest,    gather(masses, particles),           model.cloud.spacing,
            frequency, options, {particles.begin(), particles.end()}};
}

} // namespace

Simulation::Simulation(std::shared_ptr<const Model> model, SimulationOptions options)
    : model_(std::move(model)), options_(std::make_unique<const SimulationOptions>(std::move(options))),
      state_(std::make_unique<State>(starting_state(*model_, *options_))),
      solver_(make_discretization(*model_, *options_, *state_)), mass_(model_->cloud.volumes),
      contact_particles_(sorted(model_->cloud.surface_particles)),
      contact_(contact_of(*model_, contact_particles_, mass_, options_->tissue, options_->contact)),
      total_time_(loading_time(*model_, *options_)), damping_(options_->dynamics.damping / total_time_),
      rest_dt_(options_->dynamics.time_step > 0.0
                   ? options_->dynamics.time_step * total_time_
                   : critical_step(options_->dynamics.cfl, model_->cloud.spacing, wave_speed(options_->tissue))),
      loading_(options_->dynamics, options_->tissue, options_->time.start)
{
    start();
}

void Simulation::restore(State state)
{
    // How the tissue began follows from the case; where it is now from t.
    state.nodes = std::move(state_->nodes);
    state.elements = std::move(state_->elements);
    *state_ = std::move(state);
    start();
}

void Simulation::start()
{
    state_->motion.force.resize(mass_.size());
    proposed_ = state_->motion;
    if (!evaluate(state_->motion, state_->t))
    {
        give_up(state_->motion, state_->t, 0.0);
    }
}

std::vector<Vec3> Simulation::surface_positions() const
{
    return gather(state_->motion.x, model_->cloud.surface_particles);
}

Vec3 Simulation::place_of_smallest_J() const
{
    const std::vector<Vec3>& x = state_->motion.x;
    const auto at = static_cast<std::size_t>(std::max<std::int64_t>(internal_.smallest_J_at, 0));
    return model_->fem ? centroids(x, std::span(model_->fem->elements.tets).subspan(at, 1)).front() : x[at];
}

InternalResponse Simulation::internal_forces(Motion& motion, double t)
{
    const Stopwatch watch(seconds_.internal_forces);
    return solver_->evaluate(motion.x, t, motion.force);
}

void Simulation::add_contact(Motion& motion)
{
    const Stopwatch watch(seconds_.contact);
    contact_response_ = contact_.evaluate(motion.x, motion.force);
    if (options_->dynamics.time_step <= 0.0)
    {
        critical_dt_ = std::min(critical_dt_, contact_step(options_->dynamics.cfl, contact_response_.largest_rate));
    }
}

/// Shortens the step just proposed where the surface would come too close to itself.
TravelTaken Simulation::hold_apart(double dt)
{
    const Stopwatch watch(seconds_.contact);
    const std::vector<std::int32_t>& particles = contact_particles_;
    displacement_.resize(particles.size());
    parallel_runs(
        each(std::ssize(particles), [&](std::int64_t k) { displacement_[k] = dt * proposed_.v[particles[k]]; }));
    TravelTaken taken;
    for (const std::int32_t vertex : contact_.hold_apart(displacement_))
    {
        const std::int32_t i = particles[static_cast<std::size_t>(vertex)];
        const Vec3 displacement = displacement_[static_cast<std::size_t>(vertex)];
        const Vec3 velocity = displacement / dt;
        taken.energy += 0.5 * mass_[i] * (squared_norm(proposed_.v[i]) - squared_norm(velocity));
        ++taken.vertex_steps;
        proposed_.v[i] = velocity;
        proposed_.x[i] = state_->motion.x[i] + displacement;
    }
    return taken;
}

/// theta at growth time t, at the nodes and in the elements.
void Simulation::move_layer(double t)
{
    const ReferenceSize size = cortex_size(*options_);
    if (layer_moves(model_->tissue, options_->tissue, size))
    {
        set_layer(model_->tissue, options_->tissue, size, t, state_->nodes);
        if (model_->fem)
        {
            set_layer(model_->fem->tissue, options_->tissue, size, t, state_->elements);
        }
    }
}

/// Forces, energies and limits at a motion's positions; false when the positions are invalid.
bool Simulation::evaluate(Motion& motion, double t)
{
    move_layer(t);
    const InternalResponse internal = internal_forces(motion, t);
    if (internal.invalid_at >= 0)
    {
        internal_.invalid_at = internal.invalid_at;
        return false;
    }
    internal_ = internal;
    viscous_power_ = solver_->add_viscous_forces(motion.x, motion.v, motion.force);
    tissue_dt_ = options_->dynamics.time_step > 0.0
                     ? options_->dynamics.time_step * total_time_
                     : critical_step(options_->dynamics.cfl, model_->cloud.spacing, internal.stiffest_rate);
    critical_dt_ = tissue_dt_;
    if (options_->contact.enabled)
    {
        add_contact(motion);
    }
    return true;
}

/// Where a step from the present state to `t` leads; nothing where it inverts a particle on the way.
std::optional<StepEnergies> Simulation::propose(double t, double dt)
{
    const double damping = damping_ / state_->loading_rate; // drag on what moves as growth does stays the same
    if (options_->dynamics.integrator == Integrator::symplectic_euler)
    {
        StepEnergies energies = advance(state_->motion, mass_, dt, damping, proposed_);
        const bool may_cross = options_->contact.enabled && !contact_.stays_apart(energies.longest);
        travel_taken_ = may_cross ? hold_apart(dt) : TravelTaken{};
        energies.kinetic -= travel_taken_.energy;
        return energies;
    }
    const double start = state_->t;
    return runge_kutta_.advance(
        state_->motion, mass_, dt, damping,
        [&](Motion& stage, double part) { return evaluate(stage, start + part * (t - start)); }, proposed_);
}

void Simulation::step(double t_stop)
{
    const double allowed = critical_dt_;
    const double viscous_power = viscous_power_;
    const double growth_power = internal_.growth_power;
    for (std::int64_t halvings = 0;; ++halvings)
    {
        require_step(allowed * state_->step_scale);
        const double full = allowed * state_->step_scale * state_->loading_rate / total_time_;
        const double t = t_stop - state_->t <= full * (1.0 + rounding) ? t_stop : state_->t + full;
        const double dt = (t - state_->t) * total_time_ / state_->loading_rate;
        const std::optional<StepEnergies> energies = propose(t, dt);
        if (energies && evaluate(proposed_, t))
        {
            std::swap(state_->motion, proposed_);
            state_->books.growth_work += 0.5 * (growth_power + internal_.growth_power) * (t - state_->t);
            state_->books.dissipated +=
                energies->damped + travel_taken_.energy + 0.5 * (viscous_power + viscous_power_) * dt;
            state_->travel_taken.energy += travel_taken_.energy;
            state_->travel_taken.vertex_steps += travel_taken_.vertex_steps;
            state_->kinetic_energy = energies->kinetic;
            state_->loading_rate = loading_.next({state_->loading_rate, t, t - state_->t, state_->onset_t >= 0.0,
                                                  state_->kinetic_energy, internal_.elastic_energy});
            state_->t = t;
            ++state_->steps;
            state_->step_scale = std::min(1.0, state_->step_scale * step_recovery);
            note_onset();
            return;
        }
        if (halvings == options_->dynamics.max_halvings)
        {
            give_up(proposed_, t, dt);
        }
        state_->step_scale *= 0.5;
        ++state_->rejected_steps;
    }
}

void Simulation::note_onset()
{
    if (state_->steps % onset_interval != 0 || state_->onset_t >= 0.0)
    {
        return;
    }
    const std::vector<Vec3> x = surface_positions();
    const double gi = sphere_index(surface_area(x, model_->cloud.surface_triangles),
                                   enclosed_volume(x, model_->cloud.surface_triangles));
    state_->lowest_gi_sphere = std::min(state_->lowest_gi_sphere, gi);
    if (gi > state_->lowest_gi_sphere + onset_rise)
    {
        state_->onset_t = state_->t;
    }
}

void Simulation::give_up(const Motion& motion, double t, double dt) const
{
    throw RunError(fmt::format("inverted at step {}, t = {:.6g}, after {} halvings of the step (dt/T = {:.3g}): {}",
                               state_->steps + 1, t, options_->dynamics.max_halvings, dt / total_time_,
                               solver_->diagnosis(internal_.invalid_at, motion.x)));
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
                               state_->rejected_steps, state_->step_scale, cause_of_short_step()));
}

/// The pair in contact without which the step would be long enough, else the most compressed particle or tet.
std::string Simulation::cause_of_short_step() const
{
    if (critical_dt_ < tissue_dt_ && tissue_dt_ * state_->step_scale >= least_step_share * rest_dt_)
    {
        return "stiffest contact: " + contact_.stiffest_pair();
    }
    const std::int64_t at = std::max<std::int64_t>(internal_.smallest_J_at, 0);
    const std::int64_t node = model_->fem ? model_->fem->elements.tets[static_cast<std::size_t>(at)][0] : at;
    return "most compressed: " + solver_->diagnosis(node, state_->motion.x);
}

} // namespace corticle
