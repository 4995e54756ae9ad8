// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/growth_law.hpp"
#include "gate.hpp"

#include <pybind11/pybind11.h>

namespace corticle::python
{

/// A simulation as a growth law sees it: for as long as the law is being asked.
class Fields
{
  public:
    explicit Fields(const model::Simulation& shown) : shown_(&shown) {}

    /// @throws RuntimeError when the law has answered
    const model::Simulation& shown() const;
    /// From now on there is nothing to see.
    void end() { shown_ = nullptr; }

  private:
    const model::Simulation* shown_;
};

/// Growth that a Python function gives: function(week, fields) -> growth, or (growth, growth along the normal).
class CallbackLaw final : public model::GrowthLaw
{
  public:
    /// @param function  kept alive by who made the law
    explicit CallbackLaw(pybind11::handle function) : function_(function) {}

    /// @throws py::error_already_set for what the function raises; InputError for what is no growth
    void ask(const model::Simulation& present, double t, std::span<material::TissueGrowthAt> growth) override;

  private:
    pybind11::handle function_;
};

void bind_fields(pybind11::module_& module);

} // namespace corticle::python
