// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/record/run_files.hpp"
#include "module.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

namespace corticle::python
{

namespace
{

using config::Kind;
using config::Parameter;
using config::Value;

/// A number of a list; nothing where it is none.
std::optional<double> number_of(py::handle object)
{
    if (PyBool_Check(object.ptr()) || !(PyLong_Check(object.ptr()) || PyFloat_Check(object.ptr())))
    {
        return std::nullopt;
    }
    const double number = PyFloat_AsDouble(object.ptr());
    if (PyErr_Occurred() != nullptr)
    {
        PyErr_Clear(); // an integer that no double holds
        return std::nullopt;
    }
    return number;
}

Value list_of(const py::sequence& list)
{
    std::vector<double> numbers;
    for (const py::handle item : list)
    {
        const std::optional<double> number = number_of(item);
        if (!number)
        {
            return config::Unsupported{"a list with something else than numbers"};
        }
        numbers.push_back(*number);
    }
    return numbers;
}

Value integer_of(py::handle object)
{
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
    return overflow == 0 ? Value(static_cast<std::int64_t>(number))
                         : Value(config::Unsupported{"an integer of more than 64 bits"});
}

/// A Python object as a case could hold it.
Value value_of(py::handle object)
{
    if (PyBool_Check(object.ptr()))
    {
        return object.cast<bool>();
    }
    if (PyLong_Check(object.ptr()))
    {
        return integer_of(object);
    }
    if (PyFloat_Check(object.ptr()))
    {
        return object.cast<double>();
    }
    if (PyUnicode_Check(object.ptr()))
    {
        return object.cast<std::string>();
    }
    if (PyList_Check(object.ptr()) || PyTuple_Check(object.ptr()))
    {
        return list_of(py::reinterpret_borrow<py::sequence>(object));
    }
    return config::Unsupported{object.is_none() ? "None"
                                                : fmt::format("an object of type {}", Py_TYPE(object.ptr())->tp_name)};
}

py::object python_value(const Parameter& parameter, const Value& value)
{
    if (const auto* list = std::get_if<std::vector<double>>(&value))
    {
        if (parameter.kind == Kind::integers)
        {
            return py::cast(std::vector<std::int64_t>(list->begin(), list->end()));
        }
        return py::cast(*list);
    }
    return std::visit(
        [](const auto& held) -> py::object
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, config::Unsupported>)
            {
                return py::none();
            }
            else
            {
                return py::cast(held);
            }
        },
        value);
}

const Parameter& known(const std::string& key, const std::string& where)
{
    const Parameter* parameter = config::find_parameter(key);
    if (parameter == nullptr)
    {
        throw config::unknown_key_error(key, where);
    }
    return *parameter;
}

py::dict described(const Parameter& parameter)
{
    static constexpr const char* kinds[] = {"bool", "int", "float", "str", "choice", "list", "integers"};
    py::dict row;
    row["key"] = parameter.key;
    row["kind"] = kinds[static_cast<std::size_t>(parameter.kind)];
    row["unit"] = parameter.unit;
    row["expected"] = parameter.expected_text();
    row["choices"] = parameter.choices;
    row["is_path"] = parameter.is_path;
    row["sentence"] = parameter.sentence;
    row["default"] = python_value(parameter, parameter.get(config::default_options()));
    return row;
}

py::list all_parameters()
{
    py::list rows;
    for (const Parameter& parameter : config::parameters())
    {
        rows.append(described(parameter));
    }
    return rows;
}

/// Checks type and range of a value alone.
void check_value(const std::string& key, const py::object& value, const std::string& where)
{
    config::Options options;
    config::assign(options, known(key, where), value_of(value), where);
}

using Given = std::vector<std::pair<std::string, py::object>>;

/// The case of a text and of values given for keys beside it.
ResolvedCase resolve(const std::string& text, const std::string& name, const Given& given, const std::string& folder)
{
    std::vector<config::Override> overrides;
    for (const auto& [key, value] : given)
    {
        overrides.push_back({key, value_of(value), "case." + key});
    }
    ResolvedCase resolved{config::parse_overridden_case(text, name, overrides, folder), ""};
    resolved.text = config::to_toml(resolved.options);
    return resolved;
}

py::object value_in(const ResolvedCase& resolved, const std::string& key)
{
    const Parameter& parameter = known(key, "case." + key);
    return python_value(parameter, parameter.get(resolved.options));
}

} // namespace

void bind_case(py::module_& module)
{
    py::class_<ResolvedCase>(module, "ResolvedCase")
        .def_readonly("text", &ResolvedCase::text)
        .def_property_readonly("start", [](const ResolvedCase& c) { return c.options.time.start; })
        .def_property_readonly("end", [](const ResolvedCase& c) { return c.options.time.end; })
        .def("value", &value_in, py::arg("key"))
        .def("warnings", [](const ResolvedCase& c) { return config::case_warnings(c.options); })
        .def("output_times", [](const ResolvedCase& c) { return record::output_times(c.options); })
        .def(
            "growth_time",
            [](const ResolvedCase& c, double week)
            {
                return c.options.time.clock == material::GestationalClock::none
                           ? std::optional<double>()
                           : std::optional(material::growth_time(c.options.time.clock, week));
            },
            py::arg("week"));
    module.def("parameters", &all_parameters);
    module.def("check_value", &check_value, py::arg("key"), py::arg("value"), py::arg("where"));
    module.def("resolve", &resolve, py::arg("text"), py::arg("name"), py::arg("given"), py::arg("folder"));
    module.def(
        "read_case_text", [](const std::string& file) { return config::read_case_text(file); }, py::arg("file"));
}

} // namespace corticle::python
