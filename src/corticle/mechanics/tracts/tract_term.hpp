// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/force_term.hpp"
#include "corticle/mechanics/remodelling.hpp"
#include "corticle/mechanics/tracts/tracts.hpp"

namespace corticle::tracts
{

/// Where an end is, x being the positions of all nodes [mm].
Vec3 centroid(const TractEnd& end, std::span<const Vec3> x);

/// What a tract does at present.
struct TractState
{
    double length = 0.0;      ///< between its ends [mm]
    double rest_length = 0.0; ///< [mm]
    double tension = 0.0;     ///< below 0: it pushes [mu_w mm²]
};

/// Springs between the centroids of pairs of node sets, as tracts of axons that pull at what they connect (Van Essen
/// 1997). With L the distance of the ends and L_0 the rest length, the energy is k/2 (L - L_0)² where the tract is
/// stretched, or always where tracts push. L_0 goes from L at the start to a given share of it. A stretched tract grows
/// (Garcia et al. 2021): dL_0/dtime = rate (L - L_0), over a step from the length at its beginning. See
/// docs/theory/tracts.md.
class TractTerm final : public mechanics::ForceTerm
{
  public:
    /// @param X       reference positions of the nodes: lengths at the start [mm]
    /// @param masses  of the nodes
    TractTerm(Tracts tracts, std::span<const Vec3> X, std::span<const double> masses, const mechanics::RunClock& clock);

    std::string_view name() const override { return "tracts"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    std::vector<mechanics::NamedEnergy> energies() const override { return {{"tracts", energy_}}; }
    void accept(const mechanics::StepContext& context, mechanics::History& history) override;

    /// Of every tract, at the positions last asked for.
    std::span<const TractState> states() const { return states_; }

  private:
    /// Rest lengths at the end of a step.
    void grow(const mechanics::StepContext& context);
    double elongation(const TractState& state) const;
    /// How far rest lengths have come from 1 to what they are to be over the first lengths, at growth time t.
    double ramp(double t) const;
    double ramp_rate(double t) const; ///< [1/t]

    Tracts tracts_;
    mechanics::RunClock clock_;
    std::vector<double> first_length_; ///< and rest length at the start [mm]
    std::vector<TractState> states_;
    std::vector<double> kept_rest_; ///< of the last accepted step [mm]
    std::vector<double> kept_length_;
    std::vector<Vec3> centroids_; ///< of the ends
    std::vector<Vec3> end_forces_;
    double energy_ = 0.0;
    double largest_rate_ = 0.0; ///< largest frequency of the springs [1 / time]
    double growth_power_ = 0.0;
};

} // namespace corticle::tracts
