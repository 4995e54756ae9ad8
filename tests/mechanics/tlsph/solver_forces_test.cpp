// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/neo_hookean.hpp"
#include "corticle/mechanics/tlsph/kernel.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// One choice of tissue and deformation; the cloud is always the irregular sphere, with growth and a perturbation.
struct Situation
{
    material::BulkRule bulk;
    double compression; ///< all positions are scaled by it; 0.6 makes the barrier act
    double t;
};

class TlsphForces : public testing::TestWithParam<Situation>
{
  protected:
    TlsphForces() : body(test::small_sphere())
    {
        body.tissue.options.bulk = GetParam().bulk;
        for (std::size_t i = 0; i < body.tissue.regional_rate.size(); ++i)
        {
            body.tissue.regional_rate[i] = 0.7 + 0.5 * hash_uniform(5, i);
        }
        const Mat3 A = GetParam().compression * Mat3{{{1.0, 0.05, -0.1}, {0.1, 0.95, 0.1}, {-0.1, 0.1, 1.05}}};
        x = test::perturbed(test::affine(body.cloud.positions, A), 0.05 * body.cloud.spacing);
    }

    double energy(tlsph::TlsphSolver& solver, double t)
    {
        const mechanics::InternalResponse response = solver.evaluate(x, t, scratch);
        return response.elastic_energy + response.zero_mode_energy;
    }

    test::Body body;
    std::vector<Vec3> x;
    std::vector<Vec3> scratch = std::vector<Vec3>(body.cloud.positions.size());
};

TEST_P(TlsphForces, AreMinusTheGradientOfTheEnergy)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, GetParam().t, forces);
    ASSERT_EQ(response.invalid_at, -1);
    EXPECT_EQ(response.barrier_count > 0, GetParam().compression < 0.7);
    const double scale = test::largest_norm(forces);
    const auto count = static_cast<std::int32_t>(x.size());
    const auto& surface = body.cloud.surface_particles;
    for (const std::int32_t particle :
         {0, count / 3, count / 2, count - 1, surface[0], surface[surface.size() / 2], surface[surface.size() - 1]})
    {
        const auto i = static_cast<std::size_t>(particle);
        for (int axis = 0; axis < 3; ++axis)
        {
            const double h = 1e-4 * body.cloud.spacing;
            const double at = x[i][axis];
            x[i][axis] = at + h;
            const double above = energy(solver, GetParam().t);
            x[i][axis] = at - h;
            const double below = energy(solver, GetParam().t);
            x[i][axis] = at;
            // Truncation is h² ~ 1e-8 relative, round-off of an energy of some thousand over h about 1e-8.
            EXPECT_NEAR(forces[i][axis], -(above - below) / (2.0 * h), 1e-6 * scale) << "particle " << particle;
        }
    }
}

TEST_P(TlsphForces, GrowthPowerIsTheDerivativeOfTheEnergyInTime)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const double power = solver.evaluate(x, GetParam().t, scratch).growth_power;
    const double h = 1e-5;
    const double slope = (energy(solver, GetParam().t + h) - energy(solver, GetParam().t - h)) / (2.0 * h);
    // A particle that crosses the onset of the barrier within h changes the second derivative, no more.
    EXPECT_NEAR(slope / power, 1.0, 1e-6);
}

TEST_P(TlsphForces, AgreeWithPlainLoops)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, GetParam().t, forces);
    const tlsph::Particles& p = body.particles;
    std::vector<Mat3> M(x.size());
    std::vector<Mat3> R(x.size());
    std::vector<Vec3> n(x.size());
    std::vector<double> zeta(x.size());
    double elastic_energy = 0.0;
    double zero_mode_energy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        Mat3 shape;
        Mat3 moment;
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            shape += w * outer(p.X[j] - p.X[i], p.X[j] - p.X[i]);
            moment += w * outer(x[j] - x[i], p.X[j] - p.X[i]);
        }
        const Mat3 L = inverse(shape);
        const Mat3 linear_F = moment * L;
        const std::int32_t at = p.enriched.at[i];
        const tlsph::EnrichedGradient gradient =
            at < 0 ? tlsph::EnrichedGradient{L, {}, {}, {}} : p.enriched.gradient[at];
        n[i] = gradient.normal;
        Mat3 F;
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const Vec3 X_ij = p.X[j] - p.X[i];
            const Vec3 b = gradient.B * X_ij + dot(n[i], X_ij) * (gradient.Q * X_ij);
            F += p.pairs.weight[k] * outer(x[j] - x[i], b);
        }
        const auto& tissue = body.tissue;
        const material::MaterialPoint point =
            material::material_point(tissue.options, tissue.theta[i], tissue.regional_rate[i], GetParam().t);
        const double g = point.growth;
        const Mat3 G = g * Mat3::identity() + (1.0 - g) * outer(tissue.normal[i], tissue.normal[i]);
        const material::NeoHookean law{tissue.options.barrier_J};
        const material::ElasticResponse elastic =
            material::elastic_response(law, point.shear_modulus, point.bulk_modulus, F * inverse(G));
        const Mat3 P = determinant(G) * (elastic.stress * transpose(inverse(G)));
        zeta[i] = p.options.zeta * point.shear_modulus * g * g;
        M[i] = p.volume[i] * (P * gradient.B) - zeta[i] * linear_F;
        R[i] = p.volume[i] * (P * gradient.Q);
        elastic_energy += p.volume[i] * determinant(G) * (elastic.deviatoric_energy + elastic.volumetric_energy);
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            zero_mode_energy += 0.5 * zeta[i] * w * squared_norm(x[j] - x[i] - linear_F * (p.X[j] - p.X[i]));
        }
    }
    // Sums of some thousand terms in another order.
    EXPECT_NEAR(response.elastic_energy / elastic_energy, 1.0, 1e-11);
    EXPECT_NEAR(response.zero_mode_energy / zero_mode_energy, 1.0,
                1e-9); // there a difference of sums 100 times as large
    const double scale = test::largest_norm(forces);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        Vec3 force;
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            const Vec3 X_ij = p.X[j] - p.X[i];
            force += w * ((M[i] + M[j]) * X_ij + (zeta[i] + zeta[j]) * (x[j] - x[i]) + dot(n[i], X_ij) * (R[i] * X_ij) -
                          dot(n[j], X_ij) * (R[j] * X_ij));
        }
        // Products of three coordinates lose about the square of block over support in digits.
        ASSERT_LT(norm(forces[i] - force), 1e-11 * scale) << "particle " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Tissues, TlsphForces,
                         testing::Values(Situation{material::BulkRule::per_tissue, 1.0, 0.3},
                                         Situation{material::BulkRule::uniform, 1.1, 0.25},
                                         Situation{material::BulkRule::per_tissue, 0.6, 0.4}));

TEST(Particles, WeightsAreSymmetricAndThoseOfTheKernel)
{
    const tlsph::Particles& p = test::small_sphere().particles;
    const double support = p.options.support * p.spacing;
    for (std::size_t i = 0; i < p.X.size(); ++i)
    {
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            std::int64_t back = p.pairs.begin[j];
            while (back < p.pairs.begin[j + 1] &&
                   p.pairs.neighbor(static_cast<std::int64_t>(j), back) != static_cast<std::int32_t>(i))
            {
                ++back;
            }
            ASSERT_LT(back, p.pairs.begin[j + 1]);
            ASSERT_EQ(p.pairs.weight[k], p.pairs.weight[back]);
            const double exact = p.volume[i] * p.volume[j] * tlsph::pair_weight(norm(p.X[j] - p.X[i]), support);
            ASSERT_NEAR(w, exact, 1e-7 * exact); // half a unit in the last place of a float is 6e-8
        }
    }
}

} // namespace
} // namespace corticle
