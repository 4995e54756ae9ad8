// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/force_term.hpp"

#include <pybind11/pybind11.h>

#include <string>

namespace corticle::python
{

/// A force that a Python function gives: function(t, positions, velocities) -> forces, or (forces, energy).
class CallbackTerm final : public mechanics::ForceTerm
{
  public:
    /// @param function     kept alive by who made the term
    /// @param stable_step  longest step that the force allows, in time; infinite: any
    CallbackTerm(std::string name, pybind11::handle function, double stable_step)
        : name_(std::move(name)), function_(function), stable_step_(stable_step)
    {
    }

    std::string_view name() const override { return name_; }
    /// @throws py::error_already_set for what the function raises; InputError for what are no forces
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    std::vector<mechanics::NamedEnergy> energies() const override { return {{name_, energy_}}; }

  private:
    std::string name_;
    pybind11::handle function_;
    double stable_step_;
    double energy_ = 0.0;
};

} // namespace corticle::python
