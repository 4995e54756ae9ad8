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

/// Means over the tets of each node of `numbers` numbers a tet, each in an array of its own; of none, none.
std::vector<double> at_nodes(const fem::TetElements& elements, const double* values, std::size_t numbers)
{
    const std::size_t nodes = elements.X.size();
    const std::size_t tets = elements.tets.size();
    std::vector<double> means(values != nullptr ? numbers * nodes : 0);
    for (std::size_t k = 0; k < means.size() / nodes; ++k)
    {
        for (std::size_t e = 0; e < tets; ++e)
        {
            for (const std::int32_t node : elements.tets[e])
            {
                const auto i = static_cast<std::size_t>(node);
                means[k * nodes + i] += 0.25 * elements.volume[e] / elements.node_volume[i] * values[k * tets + e];
            }
        }
    }
    return means;
}

} // namespace

NodeStress::NodeStress(const Simulation& simulation) : simulation_(simulation)
{
    const mechanics::Remodelling* const remodelling = simulation.remodelling();
    if (remodelling == nullptr)
    {
        return;
    }
    view_ = &remodelling->view();
    if (const auto& fem = simulation.model().fem)
    {
        averaged_view_ = *view_;
        averaged_view_.points = fem->elements.X.size();
        const material::HistoryArrays<const double>& tets = view_->before;
        averaged_[0] = at_nodes(fem->elements, tets.strain, material::strain_size);
        averaged_[1] = at_nodes(fem->elements, tets.growth, 1);
        averaged_[2] = at_nodes(fem->elements, tets.fibre_length, 1);
        averaged_view_.before = {tets.strain != nullptr ? averaged_[0].data() : nullptr,
                                 tets.growth != nullptr ? averaged_[1].data() : nullptr,
                                 tets.fibre_length != nullptr ? averaged_[2].data() : nullptr};
        view_ = &averaged_view_;
    }
}

Mat3 NodeStress::cauchy(std::size_t node, const Mat3& F) const
{
    const material::Tissue tissue = simulation_.tissue();
    material::MaterialPoint point = tissue.point(node, simulation_.state().t);
    if (view_ != nullptr)
    {
        return material::cauchy_stress(material::remodelled_stress(*view_, tissue, node, point, F), F);
    }
    if (multiplies_growth(simulation_.options()))
    {
        point.growth = 1.0 / point.growth;
        point.radial_growth = 1.0 / point.radial_growth;
    }
    const auto law = material::tissue_law(tissue.options);
    return material::cauchy_stress(material::respond(law, point, tissue.growth_normal(node, F), F).P, F);
}

} // namespace corticle::model
