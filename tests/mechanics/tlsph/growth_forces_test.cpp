// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// One choice of growth on the irregular sphere.
struct GrowthChoice
{
    const char* name;
    double alpha_t, alpha_r, alpha_white;
    material::GrowthLaw law;
    material::NormalFrame normal;
    double start;
};

class TlsphGrowth : public testing::TestWithParam<GrowthChoice>
{
  protected:
    TlsphGrowth() : body(test::small_sphere())
    {
        const GrowthChoice& choice = GetParam();
        auto& tissue = body.tissue;
        tissue.options.alpha_t = choice.alpha_t;
        tissue.options.alpha_r = choice.alpha_r;
        tissue.options.alpha_white = choice.alpha_white;
        tissue.options.growth_law = choice.law;
        tissue.options.normal = choice.normal;
        for (std::size_t i = 0; i < tissue.regional_rate.size(); ++i)
        {
            tissue.regional_rate[i] = 0.7 + 0.5 * hash_uniform(5, i);
            tissue.growth_onset.push_back(0.1 * hash_uniform(6, i));
            tissue.growth_rate.push_back(1.0 + hash_uniform(7, i));
        }
        tissue.start_growth(choice.start);
        const Mat3 A{{{1.1, 0.05, -0.1}, {0.2, 1.05, 0.1}, {-0.1, 0.1, 1.15}}};
        x = test::perturbed(test::affine(body.cloud.positions, A), 0.05 * body.cloud.spacing);
    }

    /// Growth normals as they are at x from now on, so that G no longer moves with x.
    void fix_normals()
    {
        const std::vector<Mat3> F = tlsph::TlsphSolver(body.particles, body.tissue).deformation_gradients(x);
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            body.tissue.normal[i] = body.tissue.growth_normal(i, F[i]);
        }
        body.tissue.options.normal = material::NormalFrame::reference;
    }

    double energy(tlsph::TlsphSolver& solver, double at)
    {
        const mechanics::InternalResponse response = solver.evaluate(x, at, scratch);
        return response.elastic_energy + response.zero_mode_energy;
    }

    static constexpr double t = 0.4;
    test::Body body;
    std::vector<Vec3> x;
    std::vector<Vec3> scratch = std::vector<Vec3>(body.cloud.positions.size());
};

TEST_P(TlsphGrowth, ForcesAreMinusTheGradientOfTheEnergyAtFixedGrowth)
{
    std::vector<Vec3> forces(x.size());
    {
        tlsph::TlsphSolver moving(body.particles, body.tissue);
        ASSERT_EQ(moving.evaluate(x, t, forces).invalid_at, -1);
    }
    fix_normals();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const double scale = test::largest_norm(forces);
    const auto count = x.size();
    for (const std::size_t i : {std::size_t{0}, count / 3, count / 2, count - 1})
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const double h = 1e-4 * body.cloud.spacing;
            const double at = x[i][axis];
            x[i][axis] = at + h;
            const double above = energy(solver, t);
            x[i][axis] = at - h;
            const double below = energy(solver, t);
            x[i][axis] = at;
            EXPECT_NEAR(forces[i][axis], -(above - below) / (2.0 * h), 1e-6 * scale) << "particle " << i;
        }
    }
}

TEST_P(TlsphGrowth, PowerIsTheDerivativeOfTheEnergyInTime)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const double power = solver.evaluate(x, t, scratch).growth_power;
    const double h = 1e-5;
    EXPECT_NEAR((energy(solver, t + h) - energy(solver, t - h)) / (2.0 * h) / power, 1.0, 1e-6);
}

TEST_P(TlsphGrowth, RotationTurnsForcesAndChangesNoEnergy)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(x.size());
    std::vector<Vec3> turned(x.size());
    const double before = solver.evaluate(x, t, forces).elastic_energy;
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 1.1);
    EXPECT_NEAR(solver.evaluate(test::affine(x, Q), t, turned).elastic_energy / before, 1.0, 1e-12);
    const double scale = test::largest_norm(forces);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        // Products of three coordinates lose about the square of block over support in digits.
        ASSERT_LT(norm(turned[i] - Q * forces[i]), 1e-11 * scale);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, TlsphGrowth,
    testing::Values(
        GrowthChoice{"Regional", 1.8, 0.0, 0.0, material::GrowthLaw::linear, material::NormalFrame::reference, 0.0},
        GrowthChoice{"Isotropic", 1.0, 1.0, 0.0, material::GrowthLaw::linear, material::NormalFrame::reference, 0.0},
        GrowthChoice{"Radial", 0.2, 1.4, 0.1, material::GrowthLaw::gompertz, material::NormalFrame::reference, 0.0},
        GrowthChoice{"Late", 1.8, 0.3, 0.2, material::GrowthLaw::linear, material::NormalFrame::reference, 0.25},
        GrowthChoice{"Current", 1.8, 0.3, 0.0, material::GrowthLaw::gompertz, material::NormalFrame::current, 0.1}),
    [](const auto& tested) { return tested.param.name; });

TEST(TlsphGrowthExactness, PowerIncludesWhatAMovingLayerDoes)
{
    test::Body body = test::small_sphere();
    auto& tissue = body.tissue;
    tissue.options.thickness_rate_mm = 0.3;
    tissue.options.mu_cortex = 0.6;
    tissue.options.alpha_r = 0.2;
    tissue.size = {material::GestationalClock::wang, material::LengthLaw::quadratic, 23.0};
    tissue.set_layer(0.2);
    tissue.start_growth(0.2);
    std::vector<Vec3> forces(body.cloud.positions.size());
    const std::vector<Vec3> x = test::perturbed(body.cloud.positions, 0.05 * body.cloud.spacing);
    tlsph::TlsphSolver solver(body.particles, tissue);
    const auto response = [&](double t)
    {
        tissue.set_layer(t);
        return solver.evaluate(x, t, forces);
    };
    const auto energy = [&](double t) { return response(t).elastic_energy + response(t).zero_mode_energy; };
    const double h = 1e-5;
    EXPECT_NEAR((energy(0.5 + h) - energy(0.5 - h)) / (2.0 * h) / response(0.5).growth_power, 1.0, 1e-6);
    for (std::size_t i = 0; i < x.size(); i += 97)
    {
        tissue.set_layer(0.5 + h);
        const double above = tissue.theta[i];
        tissue.set_layer(0.5 - h);
        const double below = tissue.theta[i];
        tissue.set_layer(0.5);
        EXPECT_NEAR(tissue.theta_rate[i], (above - below) / (2.0 * h), 1e-7);
    }
}

TEST(TlsphGrowthExactness, TheGeneralLawWithPlainNumbersIsThePlainOne)
{
    test::Body body = test::small_sphere();
    std::vector<Vec3> plain(body.cloud.positions.size());
    std::vector<Vec3> general(plain.size());
    const std::vector<Vec3> x = test::perturbed(body.cloud.positions, 0.05 * body.cloud.spacing);
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const mechanics::InternalResponse a = solver.evaluate(x, 0.4, plain);
    body.tissue.growth_onset.assign(plain.size(), 0.0);
    ASSERT_FALSE(body.tissue.grows_plainly());
    const mechanics::InternalResponse b = solver.evaluate(x, 0.4, general);
    EXPECT_NEAR(b.elastic_energy / a.elastic_energy, 1.0, 1e-13);
    EXPECT_NEAR(b.zero_mode_energy / a.zero_mode_energy, 1.0, 1e-13);
    EXPECT_NEAR(b.growth_power / a.growth_power, 1.0, 1e-13);
    EXPECT_NEAR(b.stiffest_rate / a.stiffest_rate, 1.0, 1e-13);
    const double scale = test::largest_norm(plain);
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
        ASSERT_LT(norm(plain[i] - general[i]), 1e-13 * scale);
    }
}

} // namespace
} // namespace corticle
