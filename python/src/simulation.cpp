// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation.hpp"

#include "callback_law.hpp"
#include "callback_term.hpp"
#include "corticle/base/error.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/model/observer.hpp"
#include "corticle/record/checkpointing.hpp"
#include "corticle/record/run_warnings.hpp"
#include "particle_arrays.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::python
{

/// Shows a run to Python.
class Simulation::Watch final : public model::Observer
{
  public:
    Watch(Simulation& shown, const py::object& on_output, const py::object& tell)
        : shown_(shown), on_output_(on_output), poll_(tell)
    {
    }
    void on_step(const model::Simulation& simulation) override
    {
        poll_(simulation.state().t, simulation.state().steps);
    }
    void on_output(const model::OutputView& /*view*/) override
    {
        if (on_output_.is_none())
        {
            return;
        }
        const Showing showing(shown_.activity_);
        shown_.is_stale_ = false; // between steps
        on_output_();
        shown_.leave_positions();
        shown_.is_stale_ = true;
    }

  private:
    Simulation& shown_;
    const py::object& on_output_;
    Poll poll_;
};

Simulation::Simulation(std::shared_ptr<const Body> body, const ResolvedCase& resolved) : resolved_(resolved)
{
    const Work work;
    body_ = body_for(body, resolved);
    simulation_ = std::make_shared<model::Simulation>(body_->model, resolved.options);
}

template <class Get>
auto Simulation::look(Get get)
{
    if (is_stale_)
    {
        leave_positions();
    }
    const WorkIn work(activity_, false);
    if (is_stale_)
    {
        // A step that ended with an exception has left the tissue at a time it did not reach.
        simulation_->restore(model::State(simulation_->state()));
        is_stale_ = false;
    }
    return get(std::as_const(*simulation_));
}

template <class Move>
void Simulation::move(Move move)
{
    leave_positions();
    const WorkIn work(activity_, true);
    is_stale_ = true;
    move(*simulation_);
    is_stale_ = false;
}

/// Leaves the positions that are shown to the arrays that show them. Call with the GIL.
void Simulation::leave_positions()
{
    if (activity_ == Activity::working)
    {
        return; // who tries to step now is refused
    }
    if (const std::shared_ptr<PositionsShown> shown = shown_.lock())
    {
        shown->kept = simulation_->hand_over_positions();
        shown->simulation.reset();
    }
    shown_.reset();
}

/// With the GIL, for what takes no time. @throws RuntimeError while it steps
const model::Simulation& Simulation::at_rest() const
{
    if (activity_ == Activity::working)
    {
        PyErr_SetString(PyExc_RuntimeError, "the simulation is stepping, in another thread or around this call; look "
                                            "at it between steps, or from on_output");
        throw py::error_already_set();
    }
    return *simulation_;
}

void Simulation::step(double until)
{
    move([&](model::Simulation& simulation) { simulation.step(until); });
}

void Simulation::run(const std::vector<double>& times, const py::object& on_output, const py::object& tell)
{
    Watch watch(*this, on_output, tell); // with the GIL
    move(
        [&](model::Simulation& simulation)
        {
            const std::array<model::Observer*, 1> observers{&watch};
            model::fold(simulation, times, 0, observers, [] { return false; });
        });
}

void Simulation::add_force(const std::string& name, py::function function, double stable_step)
{
    functions_.push_back(function);
    move([&](model::Simulation& simulation)
         { simulation.add_term(std::make_unique<CallbackTerm>(name, functions_.back(), stable_step)); });
}

void Simulation::set_growth(py::function law)
{
    functions_.push_back(law);
    move([&](model::Simulation& simulation)
         { simulation.set_growth_law(std::make_unique<CallbackLaw>(functions_.back())); });
}

py::array Simulation::positions()
{
    const model::Simulation& simulation = at_rest();
    std::shared_ptr<PositionsShown> shown = shown_.lock();
    if (!shown)
    {
        shown = std::make_shared<PositionsShown>(PositionsShown{simulation_, {}});
        shown_ = shown;
    }
    return view(std::span<const Vec3>(simulation.state().motion.x), owner_of(std::move(shown)));
}

py::array Simulation::velocities()
{
    return array_of(std::vector<Vec3>(at_rest().state().motion.v));
}

py::array Simulation::deformation_gradients()
{
    return array_of(look([](const model::Simulation& simulation) { return simulation.deformation_gradients(); }));
}

py::array Simulation::volume_ratios()
{
    return array_of(look(volume_ratios_of));
}

py::array Simulation::stress()
{
    return array_of(look(stress_of));
}

py::array Simulation::theta()
{
    return array_of(look([](const model::Simulation& simulation) { return simulation.state().nodes.theta; }));
}

py::array Simulation::growth()
{
    return array_of(look(growth_of));
}

py::array Simulation::radial_growth()
{
    return array_of(look(radial_growth_of));
}

py::dict Simulation::surface()
{
    struct Parts
    {
        model::OutputView view;
        std::vector<double> J;
        std::vector<double> theta;
        std::vector<double> growth;
    };
    Parts parts = look(
        [](const model::Simulation& simulation)
        {
            const Cloud& cloud = simulation.model().cloud;
            return Parts{model::output_view(simulation), surface_values(cloud, volume_ratios_of(simulation)),
                         surface_values(cloud, simulation.state().nodes.theta),
                         surface_values(cloud, growth_of(simulation))};
        });
    py::dict arrays;
    arrays["J"] = array_of(std::move(parts.J));
    arrays["theta"] = array_of(std::move(parts.theta));
    arrays["growth"] = array_of(std::move(parts.growth));
    py::dict surface;
    surface["vertices"] = array_of(std::move(parts.view.surface));
    surface["triangles"] = view(std::span<const Triangle>(body_->model->cloud.surface_triangles), owner_of(body_));
    surface["arrays"] = arrays;
    surface["t"] = t();
    surface["week"] = parts.view.scale.week;
    return surface;
}

std::pair<py::dict, std::vector<std::string>> Simulation::measures()
{
    std::vector<std::string> warnings;
    const metrics::Measures row = look(
        [&](const model::Simulation& simulation)
        {
            const model::OutputView view = model::output_view(simulation);
            metrics::Measures measured = metrics::measure(view, metrics::surface_arrays(view));
            for (const record::RunWarning& warning : record::run_warnings(measured, record::size_of_run(simulation)))
            {
                warnings.push_back(warning.text);
            }
            return measured;
        });
    py::dict measures;
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        measures[py::str(std::string(column.key))] = column.of(row);
    }
    return {measures, warnings};
}

std::map<std::string, double> Simulation::energies()
{
    return look(
        [](const model::Simulation& simulation)
        {
            std::map<std::string, double> all;
            for (const mechanics::NamedEnergy& energy : simulation.energies())
            {
                all[std::string(energy.name)] += energy.value;
            }
            all["kinetic"] = simulation.state().kinetic_energy;
            return all;
        });
}

double Simulation::week()
{
    return look([](const model::Simulation& simulation) { return model::physical_scale(simulation).week; });
}

void Simulation::save(const std::string& file)
{
    look(
        [&](const model::Simulation& simulation)
        {
            record::write_checkpoint(file, record::to_checkpoint(simulation.state(), {}, resolved_.text));
            return 0;
        });
}

void Simulation::restore(const std::string& file)
{
    move(
        [&](model::Simulation& simulation)
        {
            const record::Checkpoint checkpoint = record::read_checkpoint(file);
            simulation.restore(
                record::from_checkpoint(checkpoint, simulation.model().cloud.positions.size(), file).state);
        });
}

} // namespace corticle::python
