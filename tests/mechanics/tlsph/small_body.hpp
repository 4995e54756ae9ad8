// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/random.hpp"
#include "corticle/config/parameters/options.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/prepare/prepare.hpp"

#include "material/own_tissue.hpp"

namespace corticle::test
{

/// Options of the thesis's sphere (radius 12.496 mm) with this many particles.
inline config::Options sphere_options(std::int64_t particles)
{
    config::Options options;
    options.geometry.shape = prepare::Shape::sphere;
    options.geometry.radius_mm = 12.496;
    options.geometry.particles = particles;
    options.imperfection.amplitude = 0.0; // what is exact is to be so
    return options;
}

/// A body of particles whose tissue a test may change as it likes.
struct Body
{
    Body() = default;
    Body(const model::Model& model, const model::SimulationOptions& options)
        : cloud(model.cloud), surface(model.surface), tissue(model.tissue, options.tissue, model::cortex_size(options)),
          particles(model.particles)
    {
        static_cast<material::TissueState&>(tissue) =
            material::start_tissue(model.tissue, options.tissue, tissue.size, options.time.start);
    }

    Cloud cloud;
    TriangleMesh surface;
    OwnTissue tissue;
    tlsph::Particles particles;
};

/// A sphere of about 2,500 particles, irregular, prepared once for all tests.
inline std::shared_ptr<const model::Model> small_model()
{
    static const auto model = std::make_shared<const model::Model>(prepare::prepare_body(sphere_options(2500)).model);
    return model;
}

/// The same as a body of its own.
inline Body small_sphere()
{
    return {*small_model(), sphere_options(2500)};
}

/// The particles with linear gradients everywhere.
inline tlsph::Particles without_enrichment(tlsph::Particles particles)
{
    tlsph::EnrichedGradients& enriched = particles.enriched;
    std::ranges::fill(enriched.reach, tlsph::EnrichedGradients::Reach::none);
    std::ranges::fill(enriched.group, -1);
    enriched.fits.clear();
    particles.pairs.enriched_end.assign(particles.pairs.begin.begin(), particles.pairs.begin.end() - 1);
    return particles;
}

/// A copy for simulations to share.
inline std::shared_ptr<const model::Model> shared(const model::Model& model)
{
    return std::make_shared<const model::Model>(model);
}

/// A vector with components in [-1, 1) for a counter.
inline Vec3 random_vector(std::uint64_t seed, std::uint64_t counter)
{
    const auto component = [&](std::uint64_t axis) { return 2.0 * hash_uniform(seed, 3 * counter + axis) - 1.0; };
    return {component(0), component(1), component(2)};
}

inline double largest_norm(std::span<const Vec3> vectors)
{
    double largest = 0.0;
    for (const Vec3& v : vectors)
    {
        largest = std::max(largest, norm(v));
    }
    return largest;
}

/// Positions A X + c.
inline std::vector<Vec3> affine(std::span<const Vec3> X, const Mat3& A, const Vec3& c = {})
{
    std::vector<Vec3> x;
    for (const Vec3& point : X)
    {
        x.push_back(A * point + c);
    }
    return x;
}

/// Every position moved by up to `amplitude` along each axis.
inline std::vector<Vec3> perturbed(std::span<const Vec3> positions, double amplitude, std::uint64_t seed = 7)
{
    std::vector<Vec3> x(positions.begin(), positions.end());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        x[i] += amplitude * random_vector(seed, i);
    }
    return x;
}

/// Rotation by an angle about a unit axis (Rodrigues).
inline Mat3 rotation(const Vec3& axis, double angle)
{
    const Mat3 K{{{0, axis.z, -axis.y}, {-axis.z, 0, axis.x}, {axis.y, -axis.x, 0}}};
    return Mat3::identity() + std::sin(angle) * K + (1.0 - std::cos(angle)) * (K * K);
}

/// Largest absolute entry of a - b.
inline double largest_difference(const Mat3& a, const Mat3& b)
{
    double largest = 0.0;
    for (int row = 0; row < 3; ++row)
    {
        for (int col = 0; col < 3; ++col)
        {
            largest = std::max(largest, std::abs(a(row, col) - b(row, col)));
        }
    }
    return largest;
}

} // namespace corticle::test
