// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"

#include <span>
#include <string_view>

namespace corticle::metrics
{

/// How near to equilibrium a run is and how well its energies add up. Energies that are zero within rounding, as at
/// rest, have no shares: all are then 0.
struct EquilibriumMeasures
{
    double zero_mode_share = 0.0;      ///< zero-energy control over elastic energy
    double kinetic_share = 0.0;        ///< kinetic over elastic energy
    double dissipated_share = 0.0;     ///< dissipated over the work of growth
    double energy_balance_error = 0.0; ///< |work of growth - stored - dissipated - remodelling| over the largest
    double residual_force = 0.0;       ///< see residual_force()
};

/// Energies of a run now, and what it has put in and lost since its start [mu_w mm³].
struct EnergyBalance
{
    double elastic = 0.0;
    double zero_mode = 0.0;
    double kinetic = 0.0;
    double relative_kinetic = 0.0; ///< against the mean growth of the body
    double others = 0.0;           ///< of contact and whatever else stores energy
    double dissipated = 0.0;
    double growth_work = 0.0;
    double remodelling = 0.0; ///< taken by the history of the tissue, less what active fibres put in
};

/// The shares of the energies. @param volume  of the body at rest [mm³], the scale of what rounding makes of nothing
EquilibriumMeasures equilibrium_measures(const EnergyBalance& energies, double volume);

/// Residual force, against the stress that should hold it: R sum |f_p| / sum V_i |P_i|, with f_p the force (tissue and
/// contact, without drag) on the nodes of one of 512 patches, V_i and P_i the volume and the first Piola-Kirchhoff
/// stress of node i, and R the radius of the sphere of the body's volume. 0 in equilibrium, about 1 where inertia or
/// drag carries the load instead of the tissue, whatever the resolution. 0 where the stress is only rounding.
double residual_force(const model::Simulation& simulation, std::span<const Mat3> F);

} // namespace corticle::metrics
