// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/stopwatch.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/model/terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace corticle::model
{

namespace
{

constexpr std::int64_t onset_interval = 10; ///< steps between looks at the sphere index
constexpr double onset_rise = 0.01;
constexpr double step_recovery = 1.05; ///< factor by which a halved step grows back, per step

double loading_time(const Model& model, const SimulationOptions& options)
{
    double volume = 0.0;
    for (const double V : model.cloud.volumes)
    {
        volume += V;
    }
    const double radius = std::cbrt(3.0 * volume / (4.0 * std::numbers::pi));
    return options.dynamics.loading_time * radius / material::wave_speed(options.tissue);
}

/// Of nodes of density 1.
Vec3 centre_of_mass(std::span<const Vec3> x, std::span<const double> mass)
{
    Vec3 moment{};
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        moment += mass[i] * x[i];
        sum += mass[i];
    }
    return moment / sum;
}

/// The body at rest as its growth begins.
State starting_state(const Model& model, const SimulationOptions& options)
{
    const material::ReferenceSize size = cortex_size(options);
    State state;
    state.t = options.time.start;
    state.motion.x = model.cloud.positions;
    state.motion.v.resize(model.cloud.positions.size());
    state.nodes = material::start_tissue(model.tissue, options.tissue, size, state.t);
    if (model.fem)
    {
        state.elements = material::start_tissue(model.fem->tissue, options.tissue, size, state.t);
    }
    return state;
}

material::PerTissue<double> tissue_volumes(const Model& model, const State& state)
{
    return model.fem ? material::tissue_volumes(model.fem->tissue, state.elements.theta)
                     : material::tissue_volumes(model.tissue, state.nodes.theta);
}

} // namespace

Simulation::Simulation(std::shared_ptr<const Model> model, const SimulationOptions& options)
    : Simulation(model, options, Share(std::ssize(model->cloud.positions)))
{
}

Simulation::Simulation(std::shared_ptr<const Model> model, const SimulationOptions& options, const Share& share)
    : model_(std::move(model)), options_(std::make_unique<const SimulationOptions>(options)),
      state_(std::make_unique<State>(starting_state(*model_, *options_))), share_(std::make_unique<const Share>(share)),
      known_(*share_, nodes_of_terms(*model_, *options_)), held_(*share_, held_nodes(*model_, *options_)),
      terms_(make_terms(*model_, *options_, *share_)), mass_(model_->cloud.volumes),
      total_time_(loading_time(*model_, *options_)), damping_(options_->dynamics.damping / total_time_),
      centre_(centre_of_mass(model_->cloud.positions, mass_)), tissue_volumes_(tissue_volumes(*model_, *state_)),
      rest_dt_(options_->dynamics.time_step > 0.0
                   ? options_->dynamics.time_step * total_time_
                   : dynamics::critical_step(options_->dynamics.cfl, model_->cloud.spacing,
                                             material::wave_speed(options_->tissue))),
      loading_(options_->dynamics, options_->tissue, options_->time.start)
{
    auto remodelling = make_remodelling(*model_, *options_);
    auto method = make_discretization(*model_, *options_, *state_, remodelling.get(), *share_);
    auto tissue = std::make_unique<mechanics::TissueTerm>(
        std::move(method), model_->cloud.spacing, options_->dynamics.time_step * total_time_, std::move(remodelling));
    tissue_ = tissue.get();
    terms_.insert(terms_.begin(), std::move(tissue));
    for (const auto& term : terms_)
    {
        contact_ = contact_ != nullptr ? contact_ : dynamic_cast<const contact::ContactTerm*>(term.get());
    }
    start_moving();
    start();
}

void Simulation::add_term(std::unique_ptr<mechanics::ForceTerm> term)
{
    refuse_for_ranks("forces from outside");
    const auto before = std::ranges::find_if(terms_, [](const auto& other) { return other->comes_last(); });
    const auto place = before - terms_.begin(); // before the list may move
    terms_.insert(before, std::move(term));
    try
    {
        start();
    }
    catch (...)
    {
        terms_.erase(terms_.begin() + place);
        stable_steps_.resize(terms_.size());
        throw;
    }
}

void Simulation::set_growth_law(std::unique_ptr<GrowthLaw> law)
{
    refuse_for_ranks("a growth law from outside");
    if (law_ || state_->steps > 0)
    {
        throw InputError(fmt::format("growth law: got one at step {}{}, expected one law, before the first step",
                                     state_->steps, law_ ? " of a simulation that has a law" : ""));
    }
    law_ = std::make_unique<GrowthByLaw>(std::move(law), *model_);
    try
    {
        law_->begin(*this, *state_);
        start_moving();
        start();
    }
    catch (...)
    {
        law_.reset();
        GrowthByLaw::forget(*state_);
        start_moving();
        start();
        throw;
    }
}

void Simulation::restore(State state)
{
    const std::size_t nodes = mass_.size();
    if (state.motion.x.size() != nodes || state.motion.v.size() != nodes)
    {
        throw InputError(fmt::format("the state to start from has {} positions and {} velocities; expected {}, one of "
                                     "each for every node of the body",
                                     state.motion.x.size(), state.motion.v.size(), nodes));
    }
    if (GrowthByLaw::is_in(state.history) != (law_ != nullptr))
    {
        throw InputError(fmt::format("the state to start from grew by {}; expected the same growth law as in that run",
                                     law_ ? "the keys of the case, and the simulation grows by a law from outside"
                                          : "a law from outside, which the simulation does not have"));
    }
    // How the tissue began follows from the case; where it is now from t.
    state.nodes = std::move(state_->nodes);
    state.elements = std::move(state_->elements);
    *state_ = std::move(state);
    start();
}

/// Gives the body the speed of its mean growth, so that it does not lag from the start.
void Simulation::start_moving()
{
    const dynamics::Medium around = medium(state_->t);
    if (around.expansion == 0.0 && state_->kinetic_energy == 0.0)
    {
        return;
    }
    std::ranges::transform(state_->motion.x, state_->motion.v.begin(),
                           [&](const Vec3& x) { return around.velocity(x); });
    state_->kinetic_energy = dynamics::kinetic_energies(state_->motion, mass_, around, *share_).whole;
    state_->energy_balance.growth_work = state_->kinetic_energy;
}

/// What the body moves in at growth time t. Growth by week tells how the body as a whole is to grow, and the medium
/// grows with it: drag holds back only what moves otherwise. Growth by keys does not tell, and the medium rests.
dynamics::Medium Simulation::medium(double t) const
{
    // drag on what moves as growth does stays the same
    dynamics::Medium around{damping_ / state_->loading_rate};
    const material::TissueFields& fields = model_->fem ? model_->fem->tissue : model_->tissue;
    if (fields.growth)
    {
        const double rate = law_ ? law_->mean_rate(*state_) : fields.growth->mean_rate(tissue_volumes_, t);
        around.expansion = rate * state_->loading_rate / total_time_;
        around.centre = centre_;
    }
    return around;
}

/// Takes in the present state and the list of terms.
void Simulation::start()
{
    seconds_.resize(terms_.size());
    stable_steps_.resize(terms_.size());
    state_->motion.force.resize(mass_.size());
    trial_ = state_->motion;
    if (!evaluate(state_->motion, state_->t, 0.0))
    {
        give_up(state_->motion, state_->t, 0.0);
    }
    now_ = trial_sum_;
    relative_kinetic_energy_ = dynamics::kinetic_energies(state_->motion, mass_, medium(state_->t), *share_).relative;
}

void Simulation::step(double t_stop)
{
    for (std::int64_t halvings = 0;; ++halvings)
    {
        const double stable = now_.stable_step * state_->step_scale;
        require_step(stable);
        const dynamics::StepPlan plan =
            dynamics::plan_step(state_->t, t_stop, stable, state_->loading_rate, total_time_);
        const std::optional<dynamics::StepEnergies> energies = advance(plan);
        if (energies && evaluate(trial_, plan.t, plan.dt))
        {
            return commit(plan, *energies);
        }
        if (halvings == options_->dynamics.max_halvings)
        {
            give_up(trial_, plan.t, plan.dt);
        }
        state_->step_scale *= 0.5;
        ++state_->rejected_steps;
    }
}

/// Where a step from the present state leads; nothing where it inverts a particle on the way.
std::optional<dynamics::StepEnergies> Simulation::advance(const dynamics::StepPlan& plan)
{
    const dynamics::Medium around = medium(plan.t_before);
    if (options_->dynamics.integrator == dynamics::Integrator::symplectic_euler)
    {
        dynamics::StepEnergies energies = dynamics::advance(state_->motion, mass_, plan.dt, around, *share_, trial_);
        known_.gather(trial_.x, trial_.v);
        trial_travel_ = limit_travel(plan, energies.longest);
        const double change = trial_travel_.supplied - trial_travel_.energy;
        energies.kinetic += change;
        energies.relative += change;
        return energies;
    }
    const auto energies = runge_kutta_.advance(
        state_->motion, mass_, plan.dt, around, *share_,
        [&](dynamics::Motion& stage, double part)
        {
            known_.gather(stage.x, stage.v);
            return evaluate(stage, plan.t_before + part * (plan.t - plan.t_before), part * plan.dt);
        },
        trial_);
    known_.gather(trial_.x, trial_.v);
    return energies;
}

mechanics::TravelTaken Simulation::limit_travel(const dynamics::StepPlan& plan, double longest)
{
    mechanics::TravelTaken taken;
    for (std::size_t k = terms_.size(); k-- > 0;)
    {
        const Stopwatch watch(seconds_[k]);
        taken += terms_[k]->limit_travel(state_->motion, plan, longest, trial_);
    }
    return taken;
}

/// Forces, energies and limits of all terms at a motion's positions; false when the positions are invalid.
/// @param dt  time from the present state to there
bool Simulation::evaluate(dynamics::Motion& motion, double t, double dt)
{
    if (law_)
    {
        grow_by_law(t);
    }
    move_layer(t, *share_);
    const mechanics::StepContext context{t, state_->t, dt, options_->dynamics.cfl, motion.x, motion.v, state_->history};
    trial_sum_ = {};
    tissue_->exchange_positions(motion.x);
    for (std::size_t k = 0; k < terms_.size() && trial_sum_.invalid_at < 0; ++k)
    {
        const Stopwatch watch(seconds_[k]);
        if (terms_[k]->comes_last())
        {
            held_.gather(motion.force);
        }
        const mechanics::Contribution contribution = terms_[k]->add(context, motion.force);
        stable_steps_[k] = contribution.stable_step;
        trial_sum_ += contribution;
    }
    return trial_sum_.invalid_at < 0;
}

/// Growth at t as the law says it from the present state, to which the tissue is taken back while the law looks at it.
void Simulation::grow_by_law(double t)
{
    law_->show_present(*state_);
    if (t > state_->t)
    {
        move_layer(state_->t, *share_);
        tissue_->show_present(
            {state_->t, state_->t, 0.0, options_->dynamics.cfl, state_->motion.x, state_->motion.v, state_->history});
        law_->grow(*this, t, *state_);
    }
}

/// theta at growth time t, at the nodes of a share and in the elements.
void Simulation::move_layer(double t, const Share& share)
{
    const material::ReferenceSize size = cortex_size(*options_);
    if (material::layer_moves(model_->tissue, options_->tissue, size))
    {
        material::set_layer(model_->tissue, options_->tissue, size, t, share, state_->nodes);
        if (model_->fem)
        {
            material::set_layer(model_->fem->tissue, options_->tissue, size, t, state_->elements);
        }
    }
}

/// Makes the step that was tried the present state.
void Simulation::commit(const dynamics::StepPlan& plan, const dynamics::StepEnergies& energies)
{
    const mechanics::StepContext context{plan.t,   plan.t_before, plan.dt,        options_->dynamics.cfl,
                                         trial_.x, trial_.v,      state_->history};
    for (const auto& term : terms_)
    {
        term->accept(context, state_->history);
    }
    if (law_)
    {
        law_->accept(*state_);
    }
    std::swap(state_->motion, trial_);
    const double growth_step = plan.t - plan.t_before;
    state_->energy_balance.growth_work +=
        energies.carried + trial_travel_.supplied + 0.5 * (now_.growth_power + trial_sum_.growth_power) * growth_step;
    state_->energy_balance.dissipated +=
        energies.damped + trial_travel_.energy + 0.5 * (now_.viscous_power + trial_sum_.viscous_power) * plan.dt;
    now_ = trial_sum_;
    state_->travel_taken += trial_travel_;
    state_->kinetic_energy = energies.kinetic;
    relative_kinetic_energy_ = energies.relative;
    state_->loading_rate = loading_.next({state_->loading_rate, plan.t, growth_step, state_->onset_t >= 0.0,
                                          relative_kinetic_energy_, now_.elastic_energy});
    state_->t = plan.t;
    ++state_->steps;
    state_->step_scale = std::min(1.0, state_->step_scale * step_recovery);
    note_onset();
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

} // namespace corticle::model
