// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arrays.hpp"
#include "corticle/model/simulation.hpp"
#include "gate.hpp"
#include "module.hpp"

#include <map>
#include <string>

namespace corticle::python
{

/// Positions as they were when an array of them was made. While the simulation rests they are its own memory; when it
/// goes on it leaves that memory to the arrays, if there still are any, and takes a copy.
struct PositionsShown
{
    std::shared_ptr<const model::Simulation> simulation; ///< whose memory it is, until it is kept here
    std::vector<Vec3> kept;
};

/// A simulation, as Python drives it.
class Simulation
{
  public:
    Simulation(std::shared_ptr<const Body> body, const ResolvedCase& resolved);

    double t() const { return simulation_->state().t; }
    std::int64_t steps() const { return simulation_->state().steps; }

    /// One step, no farther than growth time `until`.
    void step(double until);
    /// From output time to output time. @param on_output  callable or None, called without arguments
    /// @param tell  callable or None, called now and then with t and steps
    void run(const std::vector<double>& times, const py::object& on_output, const py::object& tell);
    void add_force(const std::string& name, py::function function, double stable_step);
    void set_growth(py::function law);

    py::array positions();
    py::array velocities();
    py::array deformation_gradients();
    py::array volume_ratios();
    py::array stress();
    py::array theta();
    py::array growth();
    py::array radial_growth();
    /// Surface in mm at the week: vertices, triangles, arrays by name, t, week.
    py::dict surface();
    /// All measures of a run, and warnings.
    std::pair<py::dict, std::vector<std::string>> measures();
    std::map<std::string, double> energies();
    double week();

    void save(const std::string& file);
    void restore(const std::string& file);

    /// What Python's collector of cycles has to know of.
    std::vector<py::object>& functions() { return functions_; }

  private:
    class Watch;

    /// Calls `get` on the simulation at rest, without the GIL.
    template <class Get>
    auto look(Get get);
    template <class Move>
    void move(Move move);
    void leave_positions();
    const model::Simulation& at_rest() const;

    std::shared_ptr<const Body> body_;
    ResolvedCase resolved_;
    std::shared_ptr<model::Simulation> simulation_;
    std::weak_ptr<PositionsShown> shown_;
    std::vector<py::object> functions_;
    Activity activity_ = Activity::none;
    bool is_stale_ = false; ///< a step ended with an exception: terms are those of the step, not of the state
};

} // namespace corticle::python
