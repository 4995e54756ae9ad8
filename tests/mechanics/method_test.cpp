// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/parallel.hpp"
#include "mechanics/methods.hpp"
#include "momenta.hpp"

#include <gtest/gtest.h>

#include <numeric>

// What every method of the tissue does exactly, on an irregular body and at its surface too.
// Forces are measured against those of a strain of order one: a node's volume over its spacing, times the modulus.

namespace corticle
{
namespace
{

using test::affine;
using test::largest_norm;
using test::perturbed;

const Mat3 stretch{{{1.2, 0.05, -0.1}, {0.1, 0.9, 0.2}, {-0.15, 0.1, 1.1}}};

template <class Body>
class Method : public testing::Test
{
  protected:
    /// Forces at these positions come to `forces`.
    mechanics::InternalResponse evaluate(std::span<const Vec3> x, double t)
    {
        return body.solver()->evaluate(x, t, forces);
    }

    double force_scale() const { return body.spacing() * body.spacing(); }

    Body body;
    std::vector<Vec3> forces = std::vector<Vec3>(body.X().size());
};

using Methods = testing::Types<test::OfParticles, test::OfGradedParticles, test::OfTets>;
TYPED_TEST_SUITE(Method, Methods);

TYPED_TEST(Method, RestIsFreeOfStrainAndForce)
{
    const mechanics::InternalResponse response = this->evaluate(this->body.X(), 0.0);
    EXPECT_EQ(response.invalid_at, -1);
    EXPECT_EQ(response.barrier_count + response.extrapolated_count + response.inverted_count, 0);
    EXPECT_NEAR(response.smallest_J, 1.0, TypeParam::round_off);
    EXPECT_LT(largest_norm(this->forces), 5.0 * TypeParam::round_off * this->force_scale());
}

TYPED_TEST(Method, AffineMotionIsReproducedEverywhere)
{
    const std::vector<Vec3> x = affine(this->body.X(), stretch, {3.0, -7.0, 2.0});
    for (const Mat3& F : this->body.solver()->deformation_gradients(x))
    {
        EXPECT_LT(test::largest_difference(F, stretch), TypeParam::round_off);
    }
    const mechanics::InternalResponse response = this->evaluate(x, 0.0);
    EXPECT_NEAR(response.smallest_J, determinant(stretch), TypeParam::round_off);
    // An affine motion has no zero-energy part: what remains is the round-off of sums as large as the elastic energy.
    EXPECT_LT(std::abs(response.zero_mode_energy), 1e-12 * response.elastic_energy);
}

TYPED_TEST(Method, RigidRotationCostsNothing)
{
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 2.3);
    const mechanics::InternalResponse response = this->evaluate(affine(this->body.X(), Q, {1.0, 2.0, 3.0}), 0.0);
    const double volume = std::accumulate(this->body.mass().begin(), this->body.mass().end(), 0.0);
    EXPECT_LT(std::abs(response.elastic_energy), 1e-13 * volume);
    EXPECT_LT(std::abs(response.zero_mode_energy), 1e-13 * volume);
    EXPECT_LT(largest_norm(this->forces), 5.0 * TypeParam::round_off * this->force_scale());
}

TYPED_TEST(Method, FreeIsotropicGrowthIsFreeOfForceAndStress)
{
    material::TissueOptions& options = this->body.tissue().options;
    options.alpha_t = options.alpha_r = options.alpha_white = 0.9;
    std::ranges::fill(this->body.tissue().regional_rate, 1.0);
    const double t = 0.5;
    const double g = 1.45;
    const auto largest_force = [&](double factor)
    {
        const mechanics::InternalResponse response =
            this->evaluate(affine(this->body.X(), factor * Mat3::identity()), t);
        EXPECT_NEAR(response.smallest_J, factor * factor * factor, 10.0 * TypeParam::round_off);
        return largest_norm(this->forces);
    };
    const double elsewhere = largest_force(1.1 * g);
    EXPECT_LT(largest_force(g), 10.0 * TypeParam::round_off * elsewhere);
}

TYPED_TEST(Method, BothMomentaAreConserved)
{
    const std::vector<Vec3> x =
        perturbed(affine(this->body.X(), stretch, {5.0, 0.0, -3.0}), 0.1 * this->body.spacing());
    ASSERT_EQ(this->evaluate(x, 0.3).invalid_at, -1);
    test::expect_momenta_conserved(x, this->forces);
}

TYPED_TEST(Method, OneAndTwoThreadsGiveTheSameBits)
{
    const std::vector<Vec3> x = perturbed(this->body.X(), 0.1 * this->body.spacing());
    const int threads = thread_count();
    set_thread_count(1);
    const mechanics::InternalResponse by_one = this->evaluate(x, 0.3);
    const std::vector<Vec3> one = this->forces;
    set_thread_count(2);
    const mechanics::InternalResponse by_two = this->evaluate(x, 0.3);
    set_thread_count(threads);
    EXPECT_EQ(one, this->forces);
    EXPECT_EQ(by_one.elastic_energy, by_two.elastic_energy);
    EXPECT_EQ(by_one.zero_mode_energy, by_two.zero_mode_energy);
    EXPECT_EQ(by_one.growth_power, by_two.growth_power);
    EXPECT_EQ(by_one.stiffest_rate, by_two.stiffest_rate);
    EXPECT_EQ(by_one.smallest_J_at, by_two.smallest_J_at);
}

} // namespace
} // namespace corticle
