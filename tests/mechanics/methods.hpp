// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/fem/force_pass.hpp"
#include "corticle/mechanics/fem/solver.hpp"
#include "corticle/mechanics/tlsph/deformation_pass.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "mechanics/fem/small_tets.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <memory>

// A small irregular body of each method, for what holds of both.

namespace corticle::test
{

struct OfParticles
{
    /// Of F near the surface, where sums are of products of three coordinates instead of differences: they lose about
    /// the square of block over support in digits.
    static constexpr double round_off = 1e-11;

    OwnTissue& tissue() { return body.tissue; }
    const std::vector<Vec3>& X() const { return body.cloud.positions; }
    const std::vector<double>& mass() const { return body.particles.volume; }
    double spacing() const { return body.cloud.spacing; }

    std::unique_ptr<mechanics::Discretization> solver() const
    {
        return std::make_unique<tlsph::TlsphSolver>(body.particles, body.tissue);
    }
    template <class Law>
    std::unique_ptr<mechanics::Discretization> solver(const Law& law) const
    {
        return std::make_unique<tlsph::TlsphSolver>(body.particles, body.tissue, tlsph::deformation_pass(law));
    }

    Body body = small_sphere();
};

/// Particles twice as far apart in the core as in the cortex.
struct OfGradedParticles : OfParticles
{
    OfGradedParticles()
    {
        config::Options options = sphere_options(4000);
        options.geometry.grading = 2.0;
        options.tissue.lambda = 0.9;
        body = Body(prepare::prepare_body(options).model, options);
    }
};

struct OfTets
{
    static constexpr double round_off = 1e-12; ///< of F

    OwnTissue& tissue() { return body.tissue; }
    const std::vector<Vec3>& X() const { return body.elements.X; }
    const std::vector<double>& mass() const { return body.elements.node_volume; }
    double spacing() const { return body.elements.spacing; }

    std::unique_ptr<mechanics::Discretization> solver() const
    {
        return std::make_unique<fem::FemSolver>(body.elements, body.tissue);
    }
    template <class Law>
    std::unique_ptr<mechanics::Discretization> solver(const Law& law) const
    {
        return std::make_unique<fem::FemSolver>(body.elements, body.tissue, fem::force_pass(law));
    }

    ElementBody body = layered_block();
};

} // namespace corticle::test
