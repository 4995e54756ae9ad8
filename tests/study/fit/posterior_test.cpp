// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/posterior.hpp"

#include "corticle/study/surrogate/minimize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace corticle
{

namespace
{

/// Normal about (0.4, 0.6) with standard deviations 0.05 and 0.1 and correlation 0.9.
double log_normal_density(std::span<const double> u)
{
    const double x = (u[0] - 0.4) / 0.05;
    const double y = (u[1] - 0.6) / 0.1;
    constexpr double r = 0.9;
    return -0.5 * (x * x - 2.0 * r * x * y + y * y) / (1.0 - r * r);
}

void expect_normal(const fit::Draws& draws)
{
    std::vector<double> first;
    std::vector<double> second;
    for (const fit::Point& point : draws.points)
    {
        first.push_back(point[0]);
        second.push_back(point[1]);
    }
    // 90 % of a normal lie within 1.645 standard deviations; draws of a walk count as about a twentieth of their
    // number.
    EXPECT_NEAR(fit::quantile(first, 0.05), 0.4 - 1.645 * 0.05, 0.01);
    EXPECT_NEAR(fit::quantile(first, 0.95), 0.4 + 1.645 * 0.05, 0.01);
    EXPECT_NEAR(fit::quantile(second, 0.5), 0.6, 0.01);
    EXPECT_NEAR(fit::correlations(draws.points)(0, 1), 0.9, 0.03);
}

} // namespace

TEST(Posterior, WalkAndLaplaceDrawFromANormalDensity)
{
    const fit::Point mode = fit::find_mode(log_normal_density, std::vector<fit::Point>{{0.9, 0.1}});
    EXPECT_NEAR(mode[0], 0.4, 1e-3);
    EXPECT_NEAR(mode[1], 0.6, 1e-3);
    const fit::Draws walked = fit::walk(log_normal_density, mode, 20000, 1);
    expect_normal(walked);
    EXPECT_LT(walked.mixing[0], 1.02);
    EXPECT_GT(walked.acceptance, 0.15);
    EXPECT_LT(walked.acceptance, 0.6);
    expect_normal(fit::laplace(log_normal_density, mode, 20000, 1));
    EXPECT_EQ(walked.points, fit::walk(log_normal_density, mode, 20000, 1).points); // the same bits
}

TEST(Posterior, ADensityThatSaysNothingFillsTheCube)
{
    const auto even = [](std::span<const double>) { return 0.0; };
    std::vector<double> values;
    for (const fit::Point& point : fit::walk(even, {0.5, 0.5}, 20000, 3).points)
    {
        values.push_back(point[1]);
    }
    EXPECT_NEAR(fit::quantile(values, 0.05), 0.05, 0.02);
    EXPECT_NEAR(fit::quantile(values, 0.95), 0.95, 0.02);
}

TEST(Posterior, IntervalsThatHoldTogetherAreWider)
{
    fit::Random random(5);
    std::vector<fit::Point> apart;
    std::vector<fit::Point> alike;
    for (int i = 0; i < 40000; ++i)
    {
        const double one = random.normal();
        apart.push_back({one, random.normal(), random.normal(), random.normal()});
        alike.push_back({one, 2.0 * one, one + 1.0});
    }
    EXPECT_NEAR(fit::level_of_each(apart, 0.9), std::pow(0.9, 0.25), 0.002);
    EXPECT_NEAR(fit::level_of_each(alike, 0.9), 0.9, 1e-3); // what goes together is as good as one
}

TEST(Minimize, MethodsAreFoundByTheirNames)
{
    EXPECT_EQ(fit::find_method("BOBYQA"), "LN_BOBYQA");
    EXPECT_EQ(fit::find_method("Nelder-Mead"), "LN_NELDERMEAD");
    EXPECT_EQ(fit::find_method("direct"), "GN_DIRECT");
    EXPECT_EQ(fit::find_method("CRS"), "GN_CRS2_LM");
    EXPECT_EQ(fit::find_method("cobyla"), "LN_COBYLA");
    EXPECT_EQ(fit::find_method("LD_LBFGS"), ""); // needs derivatives
    EXPECT_EQ(fit::find_method("simplex"), "");
}

TEST(Minimize, EveryMethodGoesTheSameWayTwiceWithinTheCube)
{
    for (const std::string& method : fit::method_names())
    {
        const auto sequence = [&]
        {
            std::vector<double> seen;
            const auto function = [&](std::span<const double> u)
            {
                EXPECT_GE(std::min(u[0], u[1]), 0.0) << method;
                EXPECT_LE(std::max(u[0], u[1]), 1.0) << method;
                seen.insert(seen.end(), u.begin(), u.end());
                return (u[0] - 0.3) * (u[0] - 0.3) + 2.0 * (u[1] - 0.9) * (u[1] - 0.9);
            };
            const fit::Minimum found =
                fit::minimize(function, std::vector<double>{0.5, 0.5}, {method, 80, 1e-4, 0.2, 7});
            EXPECT_LT(found.value, 0.08) << method; // the start has 0.36
            return seen;
        };
        EXPECT_EQ(sequence(), sequence()) << method;
    }
}

TEST(Minimize, WhatTheFunctionThrowsEndsIt)
{
    const auto function = [](std::span<const double>) -> double { throw std::runtime_error("no"); };
    EXPECT_THROW(fit::minimize(function, std::vector<double>{0.5}, {}), std::runtime_error);
}

} // namespace corticle
