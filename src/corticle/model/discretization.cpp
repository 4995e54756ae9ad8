// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/discretization.hpp"

#include "corticle/mechanics/fem/solver.hpp"
#include "corticle/mechanics/thesis/printed_solver.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"

namespace corticle
{

std::unique_ptr<Discretization> make_discretization(const Body& body, const SimulationOptions& options)
{
    if (options.method == Method::fem)
    {
        return std::make_unique<FemSolver>(body.fem->elements, body.fem->tissue);
    }
    if (options.formulation == Formulation::thesis)
    {
        return std::make_unique<PrintedSolver>(body.particles, body.tissue, options.thesis);
    }
    return std::make_unique<TlsphSolver>(body.particles, body.tissue);
}

} // namespace corticle
