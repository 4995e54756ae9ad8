// SPDX-License-Identifier: GPL-3.0-or-later
#include "callback_law.hpp"
#include "simulation.hpp"

#include <pybind11/stl.h>

namespace corticle::python
{

namespace
{

/// The simulation of a Python object; null while it is being made.
Simulation* simulation_of(PyObject* self)
{
    const auto* const instance = reinterpret_cast<py::detail::instance*>(self);
    if (!instance->simple_layout || !instance->simple_holder_constructed)
    {
        return nullptr;
    }
    return static_cast<Simulation*>(instance->simple_value_holder[0]);
}

int visit_functions(PyObject* self, visitproc visit, void* arg)
{
    Py_VISIT(Py_TYPE(self));
    if (Simulation* const simulation = simulation_of(self))
    {
        for (const py::object& function : simulation->functions())
        {
            Py_VISIT(function.ptr());
        }
    }
    return 0;
}

/// Functions are put out of reach at the end of a cycle; a simulation that is collected takes no more steps.
int clear_functions(PyObject* self)
{
    if (Simulation* const simulation = simulation_of(self))
    {
        const std::vector<py::object> last = std::move(simulation->functions());
    }
    return 0;
}

/// Functions may refer to the simulation that calls them: Python's collector has to see them.
void take_part_in_collection(PyHeapTypeObject* heap_type)
{
    PyTypeObject& type = heap_type->ht_type;
    type.tp_flags |= Py_TPFLAGS_HAVE_GC;
    type.tp_traverse = visit_functions;
    type.tp_clear = clear_functions;
}

} // namespace

void bind_simulation(py::module_& module)
{
    bind_fields(module);
    py::class_<Simulation>(module, "Simulation", py::custom_type_setup(take_part_in_collection))
        .def(py::init([](const std::shared_ptr<Body>& body, const ResolvedCase& resolved)
                      { return std::make_unique<Simulation>(body, resolved); }),
             py::arg("body"), py::arg("case"))
        .def_property_readonly("t", &Simulation::t)
        .def_property_readonly("steps", &Simulation::steps)
        .def_property_readonly("week", &Simulation::week)
        .def("step", &Simulation::step, py::arg("until"))
        .def("run", &Simulation::run, py::arg("times"), py::arg("on_output"), py::arg("tell"))
        .def("add_force", &Simulation::add_force, py::arg("name"), py::arg("function"), py::arg("stable_step"))
        .def("set_growth", &Simulation::set_growth, py::arg("law"))
        .def("positions", &Simulation::positions)
        .def("velocities", &Simulation::velocities)
        .def("deformation_gradients", &Simulation::deformation_gradients)
        .def("volume_ratios", &Simulation::volume_ratios)
        .def("stress", &Simulation::stress)
        .def("theta", &Simulation::theta)
        .def("growth", &Simulation::growth)
        .def("radial_growth", &Simulation::radial_growth)
        .def("surface", &Simulation::surface)
        .def("measures", &Simulation::measures)
        .def("energies", &Simulation::energies)
        .def("save", &Simulation::save, py::arg("file"))
        .def("restore", &Simulation::restore, py::arg("file"));
}

} // namespace corticle::python
