// SPDX-License-Identifier: GPL-3.0-or-later
#include "callback_law.hpp"

#include "arrays.hpp"
#include "corticle/base/error.hpp"
#include "corticle/mechanics/remodelling.hpp"
#include "corticle/model/physical_scale.hpp"
#include "particle_arrays.hpp"

#include <fmt/format.h>

namespace corticle::python
{

namespace
{

/// Sees to it that fields that the function keeps show nothing later.
class Shown
{
  public:
    explicit Shown(const model::Simulation& present) : fields_(std::make_shared<Fields>(present)) {}
    ~Shown() { fields_->end(); }
    Shown(const Shown&) = delete;
    Shown& operator=(const Shown&) = delete;

    const std::shared_ptr<Fields>& fields() const { return fields_; }

  private:
    std::shared_ptr<Fields> fields_;
};

void take(const py::handle& answer, double material::TissueGrowthAt::*member,
          std::span<material::TissueGrowthAt> growth)
{
    const auto array = Numbers::ensure(answer);
    if (!array || array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != growth.size())
    {
        throw InputError(
            fmt::format("growth law: got an object of type {}, expected one number for each of {} particles",
                        Py_TYPE(answer.ptr())->tp_name, growth.size()));
    }
    for (std::size_t i = 0; i < growth.size(); ++i)
    {
        growth[i].*member = array.data()[i];
    }
}

/// A copy of something that a law can look at.
template <class Get>
auto part(Get get)
{
    return [get](const Fields& fields) { return array_of(get(fields.shown())); };
}

} // namespace

const model::Simulation& Fields::shown() const
{
    if (shown_ == nullptr)
    {
        PyErr_SetString(PyExc_RuntimeError,
                        "the growth law has answered, and what it was shown has gone on: keep copies "
                        "of the arrays, not the fields");
        throw py::error_already_set();
    }
    return *shown_;
}

void CallbackLaw::ask(const model::Simulation& present, double t, std::span<material::TissueGrowthAt> growth)
{
    const model::TimeOptions& time = present.options().time;
    const py::gil_scoped_acquire locked;
    const Shown shown(present);
    const py::tuple both = function_(mechanics::RunClock{time.clock, time.start}.at(t), shown.fields());
    take(both[0], &material::TissueGrowthAt::tangential, growth);
    take(both[1], &material::TissueGrowthAt::radial, growth);
}

void bind_fields(py::module_& module)
{
    using model::Simulation;
    py::class_<Fields, std::shared_ptr<Fields>>(module, "Fields")
        .def_property_readonly("t", [](const Fields& fields) { return fields.shown().state().t; })
        .def_property_readonly("week", [](const Fields& fields) { return model::physical_scale(fields.shown()).week; })
        .def_property_readonly("positions", part([](const Simulation& s) { return s.state().motion.x; }))
        .def_property_readonly("velocities", part([](const Simulation& s) { return s.state().motion.v; }))
        .def_property_readonly("F", part([](const Simulation& s) { return s.deformation_gradients(); }))
        .def_property_readonly("J", part(volume_ratios_of))
        .def_property_readonly("stress", part(stress_of))
        .def_property_readonly("theta", part([](const Simulation& s) { return s.state().nodes.theta; }))
        .def_property_readonly("growth", part(growth_of))
        .def_property_readonly("radial_growth", part(radial_growth_of));
}

} // namespace corticle::python
