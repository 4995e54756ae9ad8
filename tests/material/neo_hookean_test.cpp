// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/neo_hookean.hpp"

#include "corticle/material/growth.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

// The numbers were computed independently of this code and are given to eight digits: hence the tolerance of 1e-7.

namespace corticle
{
namespace
{

constexpr double given_digits = 1e-7;

/// The law with the moduli of one point.
struct Solid
{
    double shear_modulus, bulk_modulus, barrier_J;

    material::ElasticResponse respond(const Mat3& F) const
    {
        return material::elastic_response(material::NeoHookean{barrier_J}, shear_modulus, bulk_modulus, F);
    }
};
constexpr Solid law{1.0, 5.0, 0.0};

Mat3 from_rows(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return transpose(Mat3{{a, b, c}});
}

const Mat3 general = from_rows({1.1, 0.2, -0.1}, {0.05, 0.9, 0.15}, {-0.2, 0.1, 1.05});

double energy(const Solid& material, const Mat3& F)
{
    const material::ElasticResponse response = material.respond(F);
    return response.deviatoric_energy + response.volumetric_energy;
}

/// The lateral stretch that leaves the sides of a bar free of stress, by bisection.
double free_lateral_stretch(double lambda)
{
    double low = 0.5;
    double high = 1.5;
    for (int step = 0; step < 60; ++step)
    {
        const double middle = 0.5 * (low + high);
        (law.respond(Mat3::diagonal(lambda, middle, middle)).stress(1, 1) < 0.0 ? low : high) = middle;
    }
    return low;
}

struct Uniaxial
{
    double lambda, lateral, J, stress;
};

class NeoHookeanUniaxial : public testing::TestWithParam<Uniaxial>
{
};

TEST_P(NeoHookeanUniaxial, LateralStretchVolumeAndStress)
{
    const auto [lambda, lateral, J, stress] = GetParam();
    const double found = free_lateral_stretch(lambda);
    const Mat3 F = Mat3::diagonal(lambda, found, found);
    const Mat3 sigma = material::cauchy_stress(law.respond(F).stress, F);
    EXPECT_NEAR(found, lateral, given_digits);
    EXPECT_NEAR(determinant(F), J, given_digits);
    EXPECT_NEAR(sigma(0, 0), stress, given_digits);
    EXPECT_NEAR(sigma(1, 1), 0.0, given_digits);
}

INSTANTIATE_TEST_SUITE_P(Stretches, NeoHookeanUniaxial,
                         testing::Values(Uniaxial{0.7, 1.15693427, 0.93694784, -0.94578243},
                                         Uniaxial{1.2, 0.92925576, 1.03621953, 0.54329298},
                                         Uniaxial{2.0, 0.76619854, 1.17412040, 2.61180595}));

TEST(NeoHookean, SimpleShear)
{
    for (const double gamma : {-0.8, 0.1, 1.5})
    {
        Mat3 F = Mat3::identity();
        F(0, 1) = gamma;
        const Mat3 sigma = material::cauchy_stress(law.respond(F).stress, F);
        const double third = gamma * gamma / 3.0;
        const Mat3 expected = from_rows({2.0 * third, gamma, 0}, {gamma, -third, 0}, {0, 0, -third});
        EXPECT_LT(test::largest_difference(sigma, expected), 1e-14); // some round-offs of numbers near 1
    }
}

TEST(NeoHookean, GeneralDeformation)
{
    const Mat3 P = from_rows({.02590251, .29768755, -.31624087}, {.30659438, -.41443649, .32588736},
                             {-.34135636, .29877335, -.08272662});
    EXPECT_NEAR(determinant(general), 0.988, 1e-14);
    EXPECT_NEAR(energy(law, general), 0.1372313010, given_digits);
    EXPECT_LT(test::largest_difference(law.respond(general).stress, P), given_digits);
}

TEST(NeoHookean, GeneralDeformationOfGrownTissue)
{
    const double g = 1.3;
    const Mat3 inverse_G = material::inverse_growth_tensor(g, Vec3{1, 2, 2} / 3.0);
    const Mat3 F_e = general * inverse_G;
    const double J_g = 1.0 / determinant(inverse_G);
    EXPECT_NEAR(J_g, 1.69, 1e-14);
    EXPECT_NEAR(determinant(F_e), 0.58461538, given_digits);
    EXPECT_NEAR(energy(law, F_e), 0.65342943, given_digits);
    const Mat3 P = J_g * (law.respond(F_e).stress * transpose(inverse_G));
    const Mat3 expected = from_rows({-2.04198301, .90451341, -.60545272}, {1.19622174, -2.82741523, 1.29215851},
                                    {-.54066301, 1.29049297, -1.99753305});
    EXPECT_LT(test::largest_difference(P, expected), given_digits);
}

TEST(NeoHookean, GrowthLeavesTheNormalAndStretchesThePlane)
{
    const Vec3 n = Vec3{1, 2, 2} / 3.0;
    const Vec3 tangent = Vec3{2, 1, -2} / 3.0;
    const Mat3 inverse_G = material::inverse_growth_tensor(1.3, n);
    EXPECT_LT(norm(inverse_G * n - n), 1e-15);
    EXPECT_LT(norm(inverse_G * tangent - tangent / 1.3), 1e-15);
}

TEST(NeoHookean, StressIsTheDerivativeOfTheEnergy)
{
    const Solid with_barrier{0.86, 4.3, 0.3};
    const Mat3 deformations[] = {general, 1.4 * general, 0.7 * general, 0.6 * general, 0.4 * general};
    const double h = 1e-6;
    for (const Mat3& F : deformations)
    {
        const Mat3 P = with_barrier.respond(F).stress;
        for (int row = 0; row < 3; ++row)
        {
            for (int col = 0; col < 3; ++col)
            {
                Mat3 above = F;
                Mat3 below = F;
                above(row, col) += h;
                below(row, col) -= h;
                const double slope = (energy(with_barrier, above) - energy(with_barrier, below)) / (2.0 * h);
                // Round-off of the energy over h, about 1e-9, and h² times a third derivative of up to a thousand.
                EXPECT_NEAR(P(row, col), slope, 1e-8 * (1.0 + std::sqrt(contract(P, P)))) << determinant(F);
            }
        }
    }
}

TEST(NeoHookean, BarrierActsBelowItsVolumeRatioAloneAndJoinsSmoothly)
{
    const Solid with_barrier{1.0, 5.0, 0.3};
    const auto pressure = [](const Solid& material, double J)
    { return material.respond(std::cbrt(J) * Mat3::identity()).stress(0, 0); };
    EXPECT_EQ(pressure(with_barrier, 0.31), pressure(law, 0.31));
    // ln(J / 0.3) / J is about 1e-6 / 0.09 at 1e-6 below the onset; a jump would be of order one.
    EXPECT_NEAR(pressure(with_barrier, 0.3 - 1e-6), pressure(law, 0.3 - 1e-6), 1e-4);
    EXPECT_LT(pressure(with_barrier, 0.1), 2.0 * pressure(law, 0.1));
    EXPECT_GT(energy(with_barrier, 1e-4 * Mat3::identity()), 100.0 * energy(law, 1e-4 * Mat3::identity()));
}

TEST(NeoHookean, RotationChangesNothing)
{
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 1.1);
    EXPECT_NEAR(energy(law, Q * general), energy(law, general), 1e-14);
    EXPECT_LT(test::largest_difference(law.respond(Q * general).stress, Q * law.respond(general).stress), 1e-14);
    EXPECT_LT(test::largest_difference(law.respond(Q).stress, Mat3{}), 1e-14);
}

TEST(InverseCubeRoot, IsRightToRoundOff)
{
    for (int k = -12000; k <= 12000; ++k)
    {
        const double a = std::pow(10.0, k / 1000.0);
        const long double exact = 1.0L / std::cbrt(static_cast<long double>(a));
        ASSERT_NEAR(static_cast<double>(inverse_cube_root(a) / exact), 1.0, 1e-15) << a;
    }
}

} // namespace
} // namespace corticle
