// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/boundary/options.hpp"
#include "corticle/mechanics/force_term.hpp"
#include "corticle/mesh/cloud.hpp"

namespace corticle::boundary
{

/// A node held along one axis.
struct HeldDegree
{
    std::int32_t node;
    std::int32_t axis;
    std::int32_t support;
};

/// What the supports of a case hold, by node and axis; where two supports agree the first of them has it.
/// @throws InputError where a support holds no node, or two want different things of one
std::vector<HeldDegree> held_degrees(const Cloud& cloud, std::span<const SupportOptions> supports);

/// What a support does at present.
struct SupportState
{
    std::int64_t nodes = 0;
    Vec3 displacement; ///< of its nodes, along the axes that it holds [mm]
    Vec3 reaction;     ///< force that it exerts on the body [mu_w mm²]
};

/// Supports: nodes that do not move, or as they are told, along some axes. They take whatever force acts there, so they
/// come last of all terms. Where a support moves the body its work counts beside that of growth.
class SupportTerm final : public mechanics::ForceTerm
{
  public:
    /// @param masses  of the nodes
    SupportTerm(const Cloud& cloud, std::span<const double> masses, std::span<const SupportOptions> supports);

    std::string_view name() const override { return "supports"; }
    bool comes_last() const override { return true; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    mechanics::TravelTaken limit_travel(const dynamics::Motion& from, const dynamics::StepPlan& plan, double& longest,
                                        dynamics::Motion& to) override;

    /// Of every support, at the positions last asked for.
    std::span<const SupportState> states() const { return states_; }

  private:
    std::vector<SupportOptions> supports_;
    std::vector<HeldDegree> held_;
    std::vector<double> rest_;   ///< reference coordinate of each of them [mm]
    std::vector<double> masses_; ///< of their nodes
    std::vector<SupportState> states_;
};

} // namespace corticle::boundary
