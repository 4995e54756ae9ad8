// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/prepare/prepare.hpp"

#include <pybind11/pybind11.h>

#include <memory>

// The parts of the module _corticle, which the package corticle is written on. Arguments are checked here and there as
// far as memory and meaning ask for; kindness to the user is the package's.

namespace corticle::python
{

namespace py = pybind11;

/// A case, resolved and checked.
struct ResolvedCase
{
    config::Options options;
    std::string text; ///< as TOML
};

/// A body and the case it was made for.
struct Body
{
    ResolvedCase resolved;
    std::shared_ptr<const model::Model> model;
    prepare::PreparationReport report;
};

/// The body for another case: the same where nothing that a body depends on differs, else with its tissue and pairs
/// made anew. @throws InputError where the arrangement would be another
std::shared_ptr<const Body> body_for(const std::shared_ptr<const Body>& body, const ResolvedCase& resolved);

void bind_errors(py::module_& module);
void bind_case(py::module_& module);
void bind_body(py::module_& module);
void bind_simulation(py::module_& module);
void bind_runs(py::module_& module);
void bind_surfaces(py::module_& module);

} // namespace corticle::python
