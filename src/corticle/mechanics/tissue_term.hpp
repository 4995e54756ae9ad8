// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/remodelling.hpp"

#include <memory>

namespace corticle::mechanics
{

/// The forces of the tissue itself, by whatever method cuts the body up.
class TissueTerm final : public ForceTerm
{
  public:
    /// @param spacing    of the nodes [mm]
    /// @param time_step  a fixed step, in time, that nobody asks whether it is stable; 0: none
    /// @param remodelling  of tissue with a history, which the method's tissue views; null: none
    TissueTerm(std::unique_ptr<Discretization> method, double spacing, double time_step,
               std::unique_ptr<Remodelling> remodelling = nullptr)
        : remodelling_(std::move(remodelling)), method_(std::move(method)), spacing_(spacing), time_step_(time_step)
    {
    }

    std::string_view name() const override { return "tissue"; }
    /// See Discretization::exchange_positions.
    void exchange_positions(std::span<Vec3> x) { method_->exchange_positions(x); }
    Contribution add(const StepContext& context, std::span<Vec3> forces) override;
    std::vector<NamedEnergy> energies() const override;
    void accept(const StepContext& context, History& history) override;
    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override
    {
        return method_->diagnosis(node, x);
    }
    std::string cause_of_short_step(std::span<const Vec3> x) const override;

    /// Takes its history back to the present, from what was tried. @param present  without a step
    void show_present(const StepContext& present);

    /// Of the last evaluation that was valid.
    const InternalResponse& response() const { return response_; }
    const Discretization& method() const { return *method_; }
    /// Null where tissue has no history.
    const Remodelling* remodelling() const { return remodelling_.get(); }

  private:
    std::unique_ptr<Remodelling> remodelling_;
    std::unique_ptr<Discretization> method_;
    double spacing_;
    double time_step_;
    InternalResponse response_;
};

} // namespace corticle::mechanics
