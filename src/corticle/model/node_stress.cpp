// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/node_stress.hpp"

#include "corticle/material/growth.hpp"
#include "corticle/material/neo_hookean.hpp"

namespace corticle
{

namespace
{

/// F G instead of F G^-1, as thesis eq. 22 prints it.
bool multiplies_growth(const SimulationOptions& options)
{
    return options.formulation == Formulation::thesis && options.thesis.growth == GrowthEntry::multiplied;
}

} // namespace

Mat3 cauchy_stress_at(const Simulation& simulation, std::size_t node, const Mat3& F)
{
    const Tissue tissue = simulation.tissue();
    const MaterialPoint point = tissue.point(node, simulation.state().t);
    const Vec3 n = tissue.growth_normal(node, F);
    const Mat3 F_e = F * (multiplies_growth(simulation.options())
                              ? inverse_growth_tensor(1.0 / point.growth, n, 1.0 / point.radial_growth)
                              : inverse_growth_tensor(point.growth, n, point.radial_growth));
    const NeoHookean law{point.shear_modulus, point.bulk_modulus, simulation.options().tissue.barrier_J};
    return cauchy_stress(law.respond(F_e).stress, F_e);
}

} // namespace corticle
