// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/kernel.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Wendland's C2 kernel.
double wendland_c2(double distance, double support)
{
    const double q = distance / support;
    if (q >= 1.0)
    {
        return 0.0;
    }
    const double p = 1.0 - q;
    return 21.0 / (2.0 * std::numbers::pi * support * support * support) * p * p * p * p * (1.0 + 4.0 * q);
}

/// Integral over the ball of radius `support` of a radial function, by the midpoint rule.
template <class Function>
double ball_integral(double support, Function&& f)
{
    constexpr int count = 20000;
    double sum = 0.0;
    for (int k = 0; k < count; ++k)
    {
        const double r = (k + 0.5) / count * support;
        sum += 4.0 * std::numbers::pi * r * r * f(r);
    }
    return sum * support / count;
}

TEST(Kernel, IntegratesToOne)
{
    for (const double support : {0.7, 2.5})
    {
        // The midpoint rule errs by about 1 / count² here.
        EXPECT_NEAR(ball_integral(support, [&](double r) { return wendland_c2(r, support); }), 1.0, 1e-7);
    }
}

TEST(Kernel, SecondMomentOfThePairWeightIsTheIdentity)
{
    for (const double support : {0.7, 2.5})
    {
        // Each diagonal entry of the integral of omega X X^T is a third of the integral of omega r².
        const double trace = ball_integral(support, [&](double r) { return r * r * tlsph::pair_weight(r, support); });
        EXPECT_NEAR(trace / 3.0, 1.0, 1e-7);
    }
}

TEST(Kernel, PairWeightIsTheSlopeOverTheDistance)
{
    const double support = 2.5;
    const double h = 1e-5;
    for (int k = 1; k < 25; ++k)
    {
        const double r = 0.1 * k;
        const double slope = (wendland_c2(r + h, support) - wendland_c2(r - h, support)) / (2.0 * h);
        // h² times a third derivative of order one, and round-off over h.
        EXPECT_NEAR(tlsph::pair_weight(r, support), -slope / r, 1e-9) << r;
    }
}

TEST(Kernel, VanishesAtTheSupport)
{
    EXPECT_EQ(wendland_c2(2.5, 2.5), 0.0);
    EXPECT_EQ(tlsph::pair_weight(2.5, 2.5), 0.0);
    EXPECT_EQ(tlsph::pair_weight(3.0, 2.5), 0.0);
    EXPECT_GT(tlsph::pair_weight(2.4999, 2.5), 0.0);
}

} // namespace
} // namespace corticle
