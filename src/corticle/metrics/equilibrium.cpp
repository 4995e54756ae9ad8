// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/equilibrium.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/model/node_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace corticle::metrics
{

namespace
{

// Below these, per volume at a shear modulus of 1, energies and stresses are rounding: strains of 1e-5 store 1e-10, and
// rounding leaves 1e-15 at most.
constexpr double least_density = 1e-10;
constexpr double least_stress = 1e-8;

double ratio(double part, double whole, double least)
{
    return whole > least ? part / whole : 0.0;
}

double frobenius(const Mat3& m)
{
    return std::sqrt(contract(m, m));
}

/// Sum of the norms of the force on each of a fixed number of patches of neighbouring nodes. Vibrations of single
/// nodes, the faster the finer the cloud, cancel in a patch; what moves a part of the body does not.
double force_of_patches(std::span<const Vec3> forces)
{
    constexpr std::int64_t patches = 512;
    const std::int64_t count = std::ssize(forces);
    return parallel_sum(patches,
                        [&](std::int64_t patch)
                        {
                            const auto begin = forces.begin() + patch * count / patches;
                            const auto end = forces.begin() + (patch + 1) * count / patches;
                            return norm(std::accumulate(begin, end, Vec3{}));
                        });
}

} // namespace

EquilibriumMeasures equilibrium_measures(const EnergyBalance& energies, double volume)
{
    const double least = least_density * volume;
    const double given = energies.elastic + energies.zero_mode + energies.kinetic + energies.others +
                         energies.dissipated + energies.remodelling;
    const double largest = std::max({std::abs(energies.growth_work), std::abs(given), std::abs(energies.remodelling)});
    EquilibriumMeasures m;
    m.zero_mode_share = ratio(energies.zero_mode, energies.elastic, least);
    m.kinetic_share = ratio(energies.relative_kinetic, energies.elastic, least);
    m.dissipated_share = ratio(energies.dissipated, energies.growth_work, least);
    m.energy_balance_error = ratio(std::abs(energies.growth_work - given), largest, least);
    return m;
}

double residual_force(const model::Simulation& simulation, std::span<const Mat3> F)
{
    struct Sums
    {
        double stress = 0.0;
        double volume = 0.0;
    };
    const std::vector<double>& volumes = simulation.model().cloud.volumes;
    const model::NodeStress stresses(simulation);
    const Sums sums = parallel_reduce(
        std::ssize(F), Sums{},
        [&](std::int64_t begin, std::int64_t end)
        {
            Sums part;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            {
                part.volume += volumes[i];
                if (determinant(F[i]) > 0.0) // the mean over inverted tets may be singular or inverted
                {
                    const Mat3 P = stresses.cauchy(i, F[i]) * cofactor(F[i]);
                    part.stress += volumes[i] * frobenius(P);
                }
            }
            return part;
        },
        [](Sums& total, const Sums& part)
        {
            total.stress += part.stress;
            total.volume += part.volume;
        });
    const double radius = std::cbrt(3.0 * sums.volume / (4.0 * std::numbers::pi));
    return ratio(radius * force_of_patches(simulation.state().motion.force), sums.stress, least_stress * sums.volume);
}

} // namespace corticle::metrics
