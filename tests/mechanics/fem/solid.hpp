// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/fill.hpp"
#include "corticle/dynamics/integrator.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "mechanics/fem/small_tets.hpp"

#include <memory>

namespace corticle::test
{

/// A homogeneous elastic body that does not grow, mu = 1 and density 1, as either method has it.
struct Solid
{
    std::vector<Vec3> X;
    std::vector<double> mass;
    double spacing = 0.0;
    ElementBody tets;           ///< of the elements
    tlsph::Particles particles; ///< of the particles
    OwnTissue tissue;           ///< of the particles
    std::unique_ptr<mechanics::Discretization> method;
};

inline OwnTissue plain_tissue(std::size_t count, std::vector<double> volume, double bulk_modulus)
{
    OwnTissue tissue;
    tissue.options.bulk_modulus = bulk_modulus;
    tissue.options.barrier_J = 0.0;
    tissue.volume = std::move(volume);
    tissue.depth.assign(count, 1.0);
    tissue.normal.assign(count, Vec3{0, 0, 1});
    tissue.regional_rate.assign(count, 1.0);
    tissue.theta.assign(count, 0.0);
    return tissue;
}

inline std::unique_ptr<Solid> solid_of_tets(const TetMesh& mesh, double bulk_modulus)
{
    auto solid = std::make_unique<Solid>();
    solid->tets = plain_elements(mesh);
    const fem::TetElements& elements = solid->tets.elements;
    solid->tets.tissue = plain_tissue(elements.tets.size(), elements.volume, bulk_modulus);
    solid->X = elements.X;
    solid->mass = elements.node_volume;
    solid->spacing = elements.spacing;
    solid->method = std::make_unique<fem::FemSolver>(elements, solid->tets.tissue);
    return solid;
}

/// Particles on the boundary of the tets and inside it.
inline std::unique_ptr<Solid> solid_of_particles(const TetMesh& mesh, double spacing, double bulk_modulus)
{
    auto solid = std::make_unique<Solid>();
    const Cloud cloud = cloud::fill_surface(boundary_of(mesh).surface, {spacing, 1});
    const tlsph::TlsphOptions options;
    solid->particles =
        tlsph::make_particles(cloud, cloud::find_pairs_within(cloud.positions, options.support * spacing), options);
    solid->tissue = plain_tissue(cloud.positions.size(), cloud.volumes, bulk_modulus);
    solid->X = cloud.positions;
    solid->mass = cloud.volumes;
    solid->spacing = cloud.spacing;
    solid->method = std::make_unique<tlsph::TlsphSolver>(solid->particles, solid->tissue);
    return solid;
}

/// Forces of the tissue and dead loads, none on what is held.
inline mechanics::InternalResponse evaluate(Solid& solid, dynamics::Motion& motion, std::span<const Vec3> loads,
                                            const std::vector<Vec3>& freedom)
{
    const mechanics::InternalResponse response = solid.method->evaluate(motion.x, 0.0, motion.force);
    for (std::size_t i = 0; i < motion.x.size(); ++i)
    {
        const Vec3 force = motion.force[i] + (loads.empty() ? Vec3{} : loads[i]);
        motion.force[i] = {freedom[i].x * force.x, freedom[i].y * force.y, freedom[i].z * force.z};
    }
    return response;
}

/// Takes steps until `stop(motion, time, kinetic energy)` says so. @param freedom  1 along each axis a node may move
template <class Stop>
bool move(Solid& solid, dynamics::Motion& motion, std::span<const Vec3> loads, const std::vector<Vec3>& freedom,
          double cfl, Stop&& stop)
{
    double time = 0.0;
    for (;;)
    {
        const mechanics::InternalResponse response = evaluate(solid, motion, loads, freedom);
        if (response.invalid_at >= 0)
        {
            return false;
        }
        const double dt = dynamics::critical_step(cfl, solid.spacing, response.stiffest_rate);
        dynamics::Motion next = motion;
        const double kinetic = dynamics::advance(motion, solid.mass, dt, {}, next).kinetic;
        motion = std::move(next);
        time += dt;
        if (stop(motion, time, kinetic))
        {
            return true;
        }
    }
}

} // namespace corticle::test
