// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/boundary/skull.hpp"

#include <memory>

namespace corticle::boundary
{

/// The skull among the forces of a simulation: its springs, its motion, its history. Stands before the terms that push
/// it, the fluid and contact.
class SkullTerm final : public mechanics::ForceTerm
{
  public:
    explicit SkullTerm(std::shared_ptr<Skull> skull) : skull_(std::move(skull)) {}

    std::string_view name() const override { return "skull"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> /*forces*/) override
    {
        skull_->begin(context);
        return {};
    }
    std::vector<mechanics::NamedEnergy> energies() const override
    {
        return {{"skull_springs", skull_->spring_energy()}, {"skull_kinetic", skull_->kinetic_energy()}};
    }
    void accept(const mechanics::StepContext& /*context*/, mechanics::History& history) override
    {
        skull_->accept(history);
    }

    const Skull& skull() const { return *skull_; }

  private:
    std::shared_ptr<Skull> skull_;
};

} // namespace corticle::boundary
