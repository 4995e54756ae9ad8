// SPDX-License-Identifier: GPL-3.0-or-later
#include "module.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/version.hpp"
#include "gate.hpp"

namespace corticle::python
{

namespace
{

py::object error_class(const char* name)
{
    return py::module_::import("corticle.errors").attr(name);
}

void raise_run_error(const RunError& error)
{
    const RunPlace& place = error.place();
    const py::object none = py::none();
    const py::object step = place.step < 0 ? none : py::object(py::int_(place.step));
    const py::object t = place.t == place.t ? py::object(py::float_(place.t)) : none;
    const py::object particle = place.node < 0 ? none : py::object(py::int_(place.node));
    const py::object type = error_class("RunError");
    const py::object made = type(error.what(), step, t, particle);
    PyErr_SetObject(type.ptr(), made.ptr());
}

} // namespace

void bind_errors(py::module_& /*module*/)
{
    py::register_exception_translator(
        [](std::exception_ptr pointer)
        {
            try
            {
                std::rethrow_exception(pointer);
            }
            catch (const InputError& error)
            {
                PyErr_SetString(error_class("InputError").ptr(), error.what());
            }
            catch (const RunError& error)
            {
                raise_run_error(error);
            }
        });
}

} // namespace corticle::python

PYBIND11_MODULE(_corticle, module)
{
    using namespace corticle;
    module.doc() = "The compiled part of corticle.";
    module.attr("version") = std::string(program_version());
    module.def("set_threads", &python::choose_threads, pybind11::arg("count"));
    module.def("threads", &python::chosen_threads);
    pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(&python::leave));
    python::bind_errors(module);
    python::bind_case(module);
    python::bind_body(module);
    python::bind_simulation(module);
    python::bind_runs(module);
    python::bind_surfaces(module);
}
