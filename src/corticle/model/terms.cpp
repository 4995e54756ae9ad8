// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/terms.hpp"

#include "corticle/mechanics/boundary/fluid_term.hpp"
#include "corticle/mechanics/boundary/skull_term.hpp"
#include "corticle/mechanics/boundary/support_term.hpp"
#include "corticle/mechanics/contact/contact_term.hpp"
#include "corticle/mechanics/fem/solver.hpp"
#include "corticle/mechanics/thesis/printed_solver.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "corticle/mechanics/tracts/tract_term.hpp"

namespace corticle::model
{

std::unique_ptr<mechanics::Remodelling> make_remodelling(const Model& model, const SimulationOptions& options)
{
    const material::RemodellingOptions& chosen = options.tissue.remodelling;
    const std::size_t points = model.fem ? model.fem->elements.tets.size() : model.cloud.positions.size();
    return chosen.any() ? std::make_unique<mechanics::Remodelling>(
                              chosen, points, mechanics::RunClock{options.time.clock, options.time.start})
                        : nullptr;
}

bool shares_work(const SimulationOptions& options)
{
    return options.method == Method::tlsph && options.formulation == thesis::Formulation::corrected;
}

Share make_share(const Model& model, const SimulationOptions& options, const Communicator& ranks)
{
    if (ranks.size() == 1 || !shares_work(options))
    {
        return Share(std::ssize(model.cloud.positions), ranks);
    }
    return {make_partition(std::ssize(model.cloud.positions), tlsph::block_costs(model.particles), ranks.size()),
            ranks};
}

std::unique_ptr<mechanics::Discretization> make_discretization(const Model& model, const SimulationOptions& options,
                                                               const State& state,
                                                               const mechanics::Remodelling* remodelling,
                                                               const Share& share)
{
    const material::RemodellingView* const history = remodelling != nullptr ? &remodelling->view() : nullptr;
    if (options.method == Method::fem)
    {
        return std::make_unique<fem::FemSolver>(
            model.fem->elements, material::Tissue{options.tissue, model.fem->tissue, state.elements, history});
    }
    const material::Tissue tissue{options.tissue, model.tissue, state.nodes, history};
    if (options.formulation == thesis::Formulation::thesis)
    {
        return std::make_unique<thesis::PrintedSolver>(model.particles, tissue, options.thesis);
    }
    return std::make_unique<tlsph::TlsphSolver>(model.particles, tissue, share);
}

namespace
{

/// The skull that the options ask for; its vertices weigh what those of the brain's surface do.
std::shared_ptr<boundary::Skull> make_skull(const Model& model, const SimulationOptions& options)
{
    if (options.boundary.shape == boundary::SkullShape::none)
    {
        return nullptr;
    }
    double mass = 0.0;
    for (const std::int32_t particle : model.cloud.surface_particles)
    {
        mass += model.cloud.volumes[static_cast<std::size_t>(particle)];
    }
    mass /= static_cast<double>(model.cloud.surface_particles.size());
    return std::make_shared<boundary::Skull>(model.skull, options.boundary, mass, options.time.start);
}

} // namespace

std::vector<std::int32_t> held_nodes(const Model& model, const SimulationOptions& options)
{
    std::vector<std::int32_t> nodes;
    for (const boundary::HeldDegree& degree : boundary::held_degrees(model.cloud, options.supports))
    {
        nodes.push_back(degree.node);
    }
    return nodes;
}

std::vector<std::int32_t> nodes_of_terms(const Model& model, const SimulationOptions& options)
{
    std::vector<std::int32_t> nodes = held_nodes(model, options);
    nodes.insert(nodes.end(), model.cloud.surface_particles.begin(), model.cloud.surface_particles.end());
    for (const auto& of_vertex : model.ventricles.nodes)
    {
        nodes.insert(nodes.end(), of_vertex.begin(), of_vertex.end());
    }
    for (const tracts::TractEnd& end : model.tracts.ends)
    {
        nodes.insert(nodes.end(), end.nodes.begin(), end.nodes.end());
    }
    return nodes;
}

std::vector<std::unique_ptr<mechanics::ForceTerm>> make_terms(const Model& model, const SimulationOptions& options,
                                                              const Share& share)
{
    std::vector<std::unique_ptr<mechanics::ForceTerm>> terms;
    const std::shared_ptr<boundary::Skull> skull = make_skull(model, options);
    if (skull)
    {
        terms.push_back(std::make_unique<boundary::SkullTerm>(skull));
    }
    if (options.boundary.fluid != boundary::Fluid::none || options.boundary.ventricle_pressure != 0.0)
    {
        terms.push_back(std::make_unique<boundary::FluidTerm>(model.cloud, model.surface, model.cloud.volumes,
                                                              model.ventricles, skull, options.boundary,
                                                              options.time.start));
    }
    if (!model.tracts.tracts.empty())
    {
        terms.push_back(
            std::make_unique<tracts::TractTerm>(model.tracts, model.cloud.positions, model.cloud.volumes,
                                                mechanics::RunClock{options.time.clock, options.time.start}));
    }
    if (options.contact.enabled)
    {
        terms.push_back(std::make_unique<contact::ContactTerm>(
            model.cloud, model.surface, model.cloud.volumes, material::wave_speed(options.tissue) / model.cloud.spacing,
            options.contact, options.dynamics.time_step > 0.0, share, skull));
    }
    if (!options.supports.empty())
    {
        terms.push_back(std::make_unique<boundary::SupportTerm>(model.cloud, model.cloud.volumes, options.supports));
    }
    return terms;
}

} // namespace corticle::model
