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

namespace
{

PyObject* require_main_interpreter(PyObject* /*module*/, PyObject* /*none*/)
{
    return is_main_interpreter() ? py::none().release().ptr() : nullptr;
}

void fill(py::module_& module)
{
    static PyMethodDef functions[] = {{"require_main_interpreter", &require_main_interpreter, METH_NOARGS,
                                       "Raises ImportError in a sub-interpreter."},
                                      {}};
    if (PyModule_AddFunctions(module.ptr(), functions) != 0)
    {
        throw py::error_already_set();
    }
    module.doc() = "The compiled part of corticle.";
    module.attr("version") = std::string(program_version());
    module.def("set_threads", &choose_threads, py::arg("count"));
    module.def("threads", &chosen_threads);
    py::module_::import("atexit").attr("register")(py::cpp_function(&leave));
    bind_errors(module);
    bind_case(module);
    bind_body(module);
    bind_simulation(module);
    bind_runs(module);
    bind_surfaces(module);
}

} // namespace

} // namespace corticle::python

/// What PYBIND11_MODULE makes, with a look at the interpreter before pybind11 does anything.
extern "C" PYBIND11_EXPORT PyObject* PyInit__corticle()
{
    namespace py = pybind11;
    if (!corticle::python::is_main_interpreter())
    {
        return nullptr;
    }
    PYBIND11_CHECK_PYTHON_VERSION
    PYBIND11_ENSURE_INTERNALS_READY
    static py::module_::module_def definition;
    py::module_ module = py::module_::create_extension_module("_corticle", nullptr, &definition);
    try
    {
        corticle::python::fill(module);
        return module.ptr();
    }
    PYBIND11_CATCH_INIT_EXCEPTIONS
}
