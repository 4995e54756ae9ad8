// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/neo_hookean.hpp"
#include "corticle/mechanics/fem/extrapolation.hpp"
#include "mechanics/fem/small_tets.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// One choice of tissue and deformation of the layered block, with growth and a perturbation.
struct Situation
{
    const char* name;
    double compression; ///< of all positions
    double roughness;   ///< of the positions [mm]; 0.35 inverts elements
    material::TissueOptions tissue;
    bool layer_moves = false;
    bool has_extrapolated = false;
};

material::TissueOptions tissue_with(const std::function<void(material::TissueOptions&)>& change)
{
    material::TissueOptions options;
    options.thickness_mm = 0.8;
    options.barrier_J = 0.1; // out of reach unless asked for
    change(options);
    return options;
}

class FemForces : public testing::TestWithParam<Situation>
{
  protected:
    FemForces() : body(test::layered_block())
    {
        body.tissue.options = GetParam().tissue;
        const Mat3 A = GetParam().compression * Mat3{{{1.0, 0.05, -0.1}, {0.1, 0.95, 0.1}, {-0.1, 0.1, 1.05}}};
        x = test::perturbed(test::affine(body.elements.X, A), GetParam().roughness);
    }

    double energy(fem::FemSolver& solver, double at)
    {
        if (GetParam().layer_moves)
        {
            body.tissue.set_layer(at);
        }
        return solver.evaluate(x, at, scratch).elastic_energy;
    }

    static constexpr double t = 0.3;
    test::ElementBody body;
    std::vector<Vec3> x;
    std::vector<Vec3> scratch = std::vector<Vec3>(body.elements.X.size());
};

TEST_P(FemForces, AreMinusTheGradientOfTheEnergy)
{
    fem::FemSolver solver(body.elements, body.tissue);
    std::vector<Vec3> forces(x.size());
    energy(solver, t);
    const mechanics::InternalResponse response = solver.evaluate(x, t, forces);
    ASSERT_EQ(response.invalid_at, -1);
    EXPECT_EQ(response.barrier_count > 0, GetParam().tissue.barrier_J > 0.5);
    EXPECT_EQ(response.extrapolated_count > 0, GetParam().has_extrapolated);
    const double scale = test::largest_norm(forces);
    for (const std::size_t i : {std::size_t{0}, x.size() / 3, x.size() / 2, 2 * x.size() / 3, x.size() - 1})
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const double h = 1e-5;
            const double at = x[i][axis];
            x[i][axis] = at + h;
            const double above = energy(solver, t);
            x[i][axis] = at - h;
            const double below = energy(solver, t);
            x[i][axis] = at;
            // Truncation and the round-off of the energy over h are both about 1e-8 of the scale.
            EXPECT_NEAR(forces[i][axis], -(above - below) / (2.0 * h), 1e-6 * scale) << "node " << i;
        }
    }
}

TEST_P(FemForces, GrowthPowerIsTheDerivativeOfTheEnergyInTime)
{
    if (GetParam().tissue.normal == material::NormalFrame::current)
    {
        GTEST_SKIP() << "the test below covers it";
    }
    fem::FemSolver solver(body.elements, body.tissue);
    energy(solver, t);
    const double power = solver.evaluate(x, t, scratch).growth_power;
    const double h = 1e-5;
    const double slope = (energy(solver, t + h) - energy(solver, t - h)) / (2.0 * h);
    EXPECT_NEAR(slope / power, 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Situations, FemForces,
    testing::Values(
        Situation{"per_tissue", 1.0, 0.05, tissue_with([](auto&) {})},
        Situation{"uniform", 1.0, 0.05, tissue_with([](auto& o) { o.bulk = material::BulkRule::uniform; })},
        Situation{"barrier", 0.8, 0.02, tissue_with([](auto& o) { o.barrier_J = 0.6; })},
        Situation{"radial", 1.0, 0.05, tissue_with([](auto& o) { o.alpha_r = 0.7, o.alpha_white = 0.4; })},
        Situation{"gompertz", 1.0, 0.05, tissue_with([](auto& o) { o.growth_law = material::GrowthLaw::gompertz; })},
        Situation{"thickening", 1.0, 0.05, tissue_with([](auto& o) { o.thickness_rate_mm = 0.3; }), true},
        Situation{"inverted", 1.0, 0.35, tissue_with([](auto& o) { o.barrier_J = 0.0; }), false, true},
        Situation{"inverted_thickening", 1.0, 0.35,
                  tissue_with([](auto& o) { o.barrier_J = 0.0, o.alpha_r = 0.5, o.thickness_rate_mm = 0.3; }), true,
                  true}),
    [](const auto& situation) { return situation.param.name; });

TEST(FemForcesOfTheCurrentNormal, AreThoseOfTheReferenceNormalTurnedBackByHand)
{
    // Where F is the same everywhere, the current normal is U^-1 n / |U^-1 n|: a reference normal may be put in its
    // place.
    test::ElementBody body = test::layered_block();
    const Mat3 A{{{1.3, 0.05, -0.1}, {0.1, 0.8, 0.1}, {-0.1, 0.1, 1.05}}};
    const std::vector<Vec3> x = test::affine(body.elements.X, A);
    std::vector<Vec3> turned(x.size());
    std::vector<Vec3> by_hand(x.size());
    body.tissue.options.normal = material::NormalFrame::current;
    fem::FemSolver(body.elements, body.tissue).evaluate(x, 0.3, turned);
    body.tissue.options.normal = material::NormalFrame::reference;
    for (Vec3& n : body.tissue.normal)
    {
        n = material::current_normal(A, n);
    }
    fem::FemSolver(body.elements, body.tissue).evaluate(x, 0.3, by_hand);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        EXPECT_LT(norm(turned[i] - by_hand[i]), 1e-12 * test::largest_norm(by_hand));
    }
}

TEST(SingularValues, GiveTheMatrixBackWithRotations)
{
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 0.7);
    const Mat3 R = test::rotation(Vec3{1, 2, 2} / 3.0, -1.9);
    for (const Vec3& stretch : {Vec3{2.0, 1.1, 0.3}, Vec3{2.0, 1.1, -0.3}, Vec3{1.0, 1.0, 1.0}, Vec3{3.0, 0.2, 0.0},
                                Vec3{1.5, 1e-9, -1e-9}, Vec3{1.0, 1.0, -1.0}, Vec3{0.0, 0.0, 0.0}})
    {
        const Mat3 F = Q * Mat3::diagonal(stretch.x, stretch.y, stretch.z) * transpose(R);
        const fem::SingularValues s = fem::singular_values(F);
        const Mat3 back = s.U * Mat3::diagonal(s.stretch.x, s.stretch.y, s.stretch.z) * transpose(s.V);
        EXPECT_LT(test::largest_difference(back, F), 1e-12);
        EXPECT_NEAR(determinant(s.U), 1.0, 1e-12);
        EXPECT_NEAR(determinant(s.V), 1.0, 1e-12);
        EXPECT_NEAR(s.stretch.z, stretch.z, 1e-12);
    }
}

TEST(Extrapolation, MeetsTheLawAtATenth)
{
    const Mat3 F = Mat3::diagonal(1.4, 0.9, fem::extrapolated_stretch);
    const material::ElasticResponse outer =
        fem::extrapolated_deviatoric(material::NeoHookean{}, fem::singular_values(F), 0.86, 4.3);
    const material::ElasticResponse law = material::elastic_response(material::NeoHookean{}, 0.86, 0.0, F);
    EXPECT_NEAR(outer.deviatoric_energy, law.deviatoric_energy, 1e-13);
    EXPECT_EQ(outer.volumetric_energy, 0.0);
    EXPECT_LT(test::largest_difference(outer.stress, law.stress), 1e-12);
}

} // namespace
} // namespace corticle
