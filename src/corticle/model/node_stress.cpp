// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/node_stress.hpp"

#include "corticle/material/response.hpp"
#include "corticle/material/tissue_law.hpp"

namespace corticle::model
{

namespace
{

/// F G instead of F G^-1, as thesis eq. 22 prints it.
bool multiplies_growth(const SimulationOptions& options)
{
    return options.formulation == thesis::Formulation::thesis &&
           options.thesis.growth == thesis::GrowthEntry::multiplied;
}

} // namespace

Mat3 cauchy_stress_at(const Simulation& simulation, std::size_t node, const Mat3& F)
{
    const material::Tissue tissue = simulation.tissue();
    material::MaterialPoint point = tissue.point(node, simulation.state().t);
    if (multiplies_growth(simulation.options()))
    {
        point.growth = 1.0 / point.growth;
        point.radial_growth = 1.0 / point.radial_growth;
    }
    const auto law = material::tissue_law(tissue.options);
    return material::cauchy_stress(material::respond(law, point, tissue.growth_normal(node, F), F).P, F);
}

} // namespace corticle::model
