// SPDX-License-Identifier: GPL-3.0-or-later
#include "particle_arrays.hpp"

#include "corticle/model/node_stress.hpp"

namespace corticle::python
{

namespace
{

/// What a function of the particle and its deformation gradient gives, for every particle.
template <class T, class Function>
std::vector<T> of_particles(const model::Simulation& simulation, Function function)
{
    const std::vector<Mat3> F = simulation.deformation_gradients();
    std::vector<T> values(F.size());
    for (std::size_t i = 0; i < F.size(); ++i)
    {
        values[i] = function(i, F[i]);
    }
    return values;
}

std::vector<double> of_points(const model::Simulation& simulation, double material::MaterialPoint::*member)
{
    std::vector<double> values(simulation.state().motion.x.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        values[i] = simulation.tissue().point(i, simulation.state().t).*member;
    }
    return values;
}

} // namespace

std::vector<double> volume_ratios_of(const model::Simulation& simulation)
{
    return of_particles<double>(simulation, [](std::size_t, const Mat3& F) { return determinant(F); });
}

std::vector<Mat3> stress_of(const model::Simulation& simulation)
{
    const model::NodeStress stresses(simulation);
    return of_particles<Mat3>(simulation, [&](std::size_t i, const Mat3& F) { return stresses.cauchy(i, F); });
}

std::vector<double> growth_of(const model::Simulation& simulation)
{
    return of_points(simulation, &material::MaterialPoint::growth);
}

std::vector<double> radial_growth_of(const model::Simulation& simulation)
{
    return of_points(simulation, &material::MaterialPoint::radial_growth);
}

} // namespace corticle::python
