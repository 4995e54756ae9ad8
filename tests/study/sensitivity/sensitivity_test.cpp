// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/morris.hpp"
#include "corticle/study/sensitivity/sobol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corticle
{

namespace
{

/// Ishigami & Homma 1990, a = 7 and b = 0.1, over [-pi, pi]³. Its indices: with V = a²/8 + b pi⁴/5 + b² pi⁸/18 + 1/2,
/// V1 = (1 + b pi⁴/5)²/2, V2 = a²/8, V13 = 8 b² pi⁸/225.
double ishigami(std::span<const double> u)
{
    const auto angle = [&](std::size_t k) { return std::numbers::pi * (2.0 * u[k] - 1.0); };
    const double s2 = std::sin(angle(1));
    return std::sin(angle(0)) + 7.0 * s2 * s2 + 0.1 * std::pow(angle(2), 4.0) * std::sin(angle(0));
}

void expect_ishigami(const sensitivity::SobolIndices& indices)
{
    const double pi4 = std::pow(std::numbers::pi, 4.0);
    const double v1 = 0.5 * std::pow(1.0 + 0.1 * pi4 / 5.0, 2.0);
    const double v2 = 49.0 / 8.0;
    const double v13 = 8.0 * 0.01 * pi4 * pi4 / 225.0;
    const double v = v1 + v2 + v13;
    EXPECT_NEAR(indices.variance, v, 0.03 * v);
    const double first[] = {v1 / v, v2 / v, 0.0};
    const double total[] = {(v1 + v13) / v, v2 / v, v13 / v};
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(indices.first[k], first[k], 0.02) << k;
        EXPECT_NEAR(indices.total[k], total[k], 0.02) << k;
    }
}

} // namespace

TEST(Sobol, IndicesOfIshigami)
{
    expect_ishigami(sensitivity::sobol_indices(ishigami, 3, 8192, 1));
}

TEST(Sobol, IndicesOfIshigamiFromSomeRuns)
{
    const std::vector<fit::Point> points = fit::latin_hypercube(220, 3, 1);
    std::vector<double> values;
    for (const fit::Point& point : points)
    {
        values.push_back(ishigami(point));
    }
    const fit::GaussianProcess process(points, values);
    EXPECT_GT(process.predictivity(), 0.98);
    expect_ishigami(sensitivity::sobol_indices([&](std::span<const double> u) { return process.mean(u); }, 3, 4096, 1));
}

TEST(Sobol, IntervalsHoldTheIndicesOfFewRuns)
{
    // Of 3 x + y the first indices are 0.9 and 0.1; runs scatter by a tenth of the variance.
    const std::vector<fit::Point> points = fit::latin_hypercube(30, 2, 1);
    fit::Random random(2);
    std::vector<double> values;
    for (const fit::Point& u : points)
    {
        values.push_back(3.0 * u[0] + u[1] + std::sqrt(0.1 * 10.0 / 12.0) * random.normal());
    }
    const sensitivity::EmulatedIndices found = sensitivity::emulated_indices(points, values, 1024, 1);
    for (std::size_t k = 0; k < 2; ++k)
    {
        EXPECT_NEAR(found.indices.first[k], k == 0 ? 0.9 : 0.1, 2.0 * found.first_error[k] + 0.02);
        EXPECT_LT(found.first_error[k], 0.25);
        EXPECT_GT(found.first_error[k], 0.005);
    }
    EXPECT_NEAR(found.scatter_share, 0.1 / 1.1, 0.06);
}

TEST(Morris, EachStepChangesOneCoordinateWithinTheCube)
{
    const std::vector<fit::Point> points = sensitivity::morris_paths(5, 4, 6, 1);
    ASSERT_EQ(points.size(), 25u);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        int changed = 0;
        for (std::size_t k = 0; k < 4; ++k)
        {
            EXPECT_GE(points[i][k], -1e-12);
            EXPECT_LE(points[i][k], 1.0 + 1e-12);
            changed += i % 5 != 0 && points[i][k] != points[i - 1][k] ? 1 : 0;
        }
        EXPECT_EQ(changed, i % 5 == 0 ? 0 : 1);
    }
}

TEST(Morris, EffectsOfALinearFunctionAreItsCoefficients)
{
    const std::vector<fit::Point> points = sensitivity::morris_paths(6, 3, 4, 2);
    std::vector<double> values;
    for (const fit::Point& u : points)
    {
        values.push_back(4.0 * u[0] - 2.0 * u[1]);
    }
    values[3] = std::nan(""); // a run that failed
    const auto effects = sensitivity::elementary_effects(points, values);
    EXPECT_NEAR(effects[0].mean, 4.0, 1e-12);
    EXPECT_NEAR(effects[1].mean, -2.0, 1e-12);
    EXPECT_NEAR(effects[1].mean_magnitude, 2.0, 1e-12);
    EXPECT_NEAR(effects[2].mean_magnitude, 0.0, 1e-12);
    EXPECT_NEAR(effects[0].deviation, 0.0, 1e-12);
    EXPECT_LT(effects[0].count + effects[1].count + effects[2].count, 18u);
}

TEST(Morris, OrdersTheParametersOfIshigamiAndSeesTheInteraction)
{
    const std::vector<fit::Point> points = sensitivity::morris_paths(60, 3, 4, 3);
    std::vector<double> values;
    for (const fit::Point& u : points)
    {
        values.push_back(ishigami(u));
    }
    const auto effects = sensitivity::elementary_effects(points, values);
    // The third matters by its interaction with the first alone, and least.
    EXPECT_GT(effects[0].mean_magnitude, effects[2].mean_magnitude);
    EXPECT_GT(effects[1].mean_magnitude, effects[2].mean_magnitude + effects[2].error);
    EXPECT_GT(effects[2].deviation, effects[2].mean_magnitude);
}

} // namespace corticle
