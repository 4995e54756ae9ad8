// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/remodelled.hpp"

#include "corticle/base/dual.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

constexpr double round_off = 1e-12; // some hundred operations on numbers of order one
constexpr material::NeoHookean matrix{0.3};
constexpr std::uint64_t situations = 12;

material::RemodellingStep step_of_all()
{
    material::RemodellingStep step;
    step.elapsed = 0.01;
    step.relaxation_share = 0.6;
    step.relaxation = 0.2;
    step.growth = 0.05;
    step.has_fibres = true;
    step.fibre_stiffness = 1.5;
    step.tension = 0.2;
    step.fibre_growth = 0.05;
    return step;
}

Mat3 deformation(std::uint64_t k)
{
    Mat3 F = Mat3::identity();
    for (std::uint64_t c = 0; c < 3; ++c)
    {
        F.column[c] += 0.25 * test::random_vector(7, 3 * k + c);
    }
    return F;
}

/// A strain that the branch has flowed to.
Mat3 flowed_strain(std::uint64_t k)
{
    const Mat3 F = deformation(100 + k);
    return material::flowed(Mat3::identity(), F, determinant(F), 0.8);
}

/// In any precision.
template <RealLike Real>
struct Situation
{
    material::BasicMaterialPoint<Real> point;
    BasicVec3<Real> normal;
    BasicMat3<Real> F;
    material::BasicFibre<Real> fibre;
    material::BasicPointHistory<Real> history;
};

template <RealLike Real>
Situation<Real> situation(std::uint64_t k)
{
    const auto number = [](double value) { return Real(static_cast<ScalarOf<Real>>(value)); };
    const auto vector = [&](const Vec3& v) { return BasicVec3<Real>{number(v.x), number(v.y), number(v.z)}; };
    const auto tensor = [&](const Mat3& A) {
        return BasicMat3<Real>{{vector(A.column[0]), vector(A.column[1]), vector(A.column[2])}};
    };
    const auto random = [&](std::uint64_t which) { return hash_uniform(5, 32 * k + which); };
    return {{number(1.0 + random(0)), number(0.8 + 0.4 * random(1)), number(1.8 * random(2)), number(random(3)),
             number(0.5 + random(4)), number(2.0 + 5.0 * random(5)), number(random(6) - 0.5), number(random(7) - 0.5)},
            vector(normalized(test::random_vector(6, k))),
            tensor(1.3 * deformation(k)),
            {vector(normalized(test::random_vector(8, k))), number(0.4 + 0.6 * random(8))},
            {tensor(flowed_strain(k)), number(1.0 + 0.2 * random(9)), number(0.9 + 0.2 * random(10))}};
}

template <RealLike Real>
material::BasicResponse<Real> response_of(const Situation<Real>& s)
{
    const auto step = step_of_all();
    return material::respond(material::remodelled(step, step.tension, matrix, s.fibre, s.history), s.point, s.normal,
                             s.F);
}

TEST(Remodelled, StressIsTheDerivativeOfTheEnergy)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        const material::Response exact = response_of(situation<double>(k));
        for (int entry = 0; entry < 9; ++entry)
        {
            auto s = situation<Dual>(k);
            s.F(entry / 3, entry % 3).slope = 1.0;
            const auto derived = response_of(s);
            EXPECT_NEAR((derived.growth_volume * derived.energy).slope, exact.P(entry / 3, entry % 3), 10 * round_off)
                << k;
        }
    }
}

TEST(Remodelled, PowerIsTheRateOfTheEnergyAsThePointGrows)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        auto s = situation<Dual>(k);
        s.point.growth.slope = s.point.growth_rate.value;
        s.point.radial_growth.slope = s.point.radial_growth_rate.value;
        s.point.shear_modulus.slope = s.point.shear_rate.value;
        s.point.bulk_modulus.slope = s.point.bulk_rate.value;
        const auto derived = response_of(s);
        const double rate = (derived.growth_volume * derived.energy).slope;
        EXPECT_NEAR(derived.growth_volume.value * derived.power.value, rate, 10 * round_off * (10.0 + std::abs(rate)));
    }
}

TEST(Remodelled, FloatGivesTheNumbersOfDouble)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        const material::Response exact = response_of(situation<double>(k));
        const auto single = response_of(situation<float>(k));
        EXPECT_NEAR(static_cast<double>(single.energy), exact.energy, 1e-4);
        EXPECT_NEAR(static_cast<double>(single.P(0, 1)), exact.P(0, 1), 1e-4);
    }
}

TEST(Remodelled, StressTurnsWithTheBody)
{
    const Mat3 R = test::rotation(normalized(Vec3{1, 2, 3}), 0.7);
    const auto s = situation<double>(3);
    auto turned = s;
    turned.F = R * s.F;
    EXPECT_LT(test::largest_difference(response_of(turned).P, R * response_of(s).P), 10 * round_off);
}

TEST(Remodelled, WithoutHistoryIsTheMatrix)
{
    auto s = situation<double>(2);
    s.history = {Mat3::identity(), 1.0, 1.0};
    s.fibre.share = 0.0;
    EXPECT_LT(test::largest_difference(response_of(s).P, material::respond(matrix, s.point, s.normal, s.F).P),
              round_off);
}

TEST(Relaxation, StressOfAHeldShearFallsToTheShareThatStays)
{
    constexpr double shear = 1e-4;
    constexpr double share = 0.6;
    constexpr int steps = 1000;
    material::RemodellingStep step;
    step.relaxation_share = share;
    step.relaxation = 1.0 / steps; // of tau in all
    Mat3 F = Mat3::identity();
    F(0, 1) = shear;
    material::BasicPointHistory<double> history{Mat3::identity(), 1.0, 1.0};
    for (int k = 0; k < steps; ++k)
    {
        history.strain = material::flowed(history.strain, F, 1.0, step.relaxation);
    }
    const auto law = material::remodelled(step, 0.0, matrix, material::BasicFibre<double>{}, history);
    const double stress = material::elastic_response(law, 1.0, 5.0, F).stress(0, 1);
    // Implicit Euler errs by half a step.
    EXPECT_NEAR(stress / shear, 1.0 - share + share * std::exp(-1.0), 1e-3);
}

TEST(Relaxation, KeepsTheVolumeAndTakesEnergy)
{
    const auto step = step_of_all();
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        const Mat3 F = 1.2 * deformation(k);
        const Mat3 before = flowed_strain(k);
        const Mat3 after = material::flowed(before, F, determinant(F), step.relaxation);
        EXPECT_NEAR(determinant(after), 1.0, round_off);
        const auto energy = [&](const Mat3& strain)
        {
            const auto law =
                material::remodelled(step, 0.0, matrix, material::BasicFibre<double>{}, {strain, 1.0, 1.0});
            return material::elastic_response(law, 1.0, 5.0, F).deviatoric_energy;
        };
        EXPECT_GT(energy(before), energy(after)) << k;
    }
}

TEST(StressGrowth, FollowsTheVolumeAtItsRate)
{
    // x' = y / x - 1 from x = 1 with y = 1.21 goes to x = 1.1, by implicit Euler within a step of the exact course.
    double x = 1.0;
    for (int k = 0; k < 100; ++k)
    {
        const double before = x;
        x = material::followed(x, 1.21, 0.5, 1.1, true);
        EXPECT_NEAR((x - before) / 0.5, 1.21 / x - 1.1, round_off);
    }
    EXPECT_NEAR(x, 1.1, 1e-9);
    EXPECT_EQ(material::followed(1.3, 1.21, 0.5, 1.1, false), 1.3); // one way only
    EXPECT_LT(material::followed(1.3, 1.21, 0.5, 1.1, true), 1.3);
    EXPECT_EQ(material::followed(1.3, 1.21, 0.0, 1.1, true), 1.3);
}

TEST(Fibres, PullWithTheirTensionAndCarryNoCompression)
{
    material::RemodellingStep step;
    step.has_fibres = true;
    step.fibre_stiffness = 2.0;
    const material::BasicFibre<double> fibre{{1, 0, 0}, 0.5};
    const auto pull = [&](double stretch, double tension)
    {
        const auto law = material::remodelled(step, tension, matrix, fibre, {Mat3::identity(), 1.0, 1.1});
        return law.respond_of_fibres(3.0, Mat3::diagonal(stretch, 1.0, 1.0)).stress(0, 0);
    };
    EXPECT_EQ(pull(0.9, 0.0), 0.0);
    EXPECT_NEAR(pull(0.9, 0.2), 0.5 * 3.0 * 0.2, round_off);
    EXPECT_NEAR(pull(1.21, 0.2), 0.5 * 3.0 * (0.2 + 2.0 * 0.1 / 1.1), round_off);
}

} // namespace
} // namespace corticle
