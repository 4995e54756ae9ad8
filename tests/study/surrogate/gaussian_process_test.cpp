// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/surrogate/gaussian_process.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{

namespace
{

double smooth(const fit::Point& u)
{
    return std::exp(u[0]) * std::cos(2.0 * u[1]) + u[0] * u[1] * u[1];
}

std::vector<double> values_of(const std::vector<fit::Point>& points, double (*function)(const fit::Point&))
{
    std::vector<double> values;
    for (const fit::Point& point : points)
    {
        values.push_back(function(point));
    }
    return values;
}

} // namespace

TEST(GaussianProcess, LearnsASmoothFunction)
{
    const std::vector<fit::Point> points = fit::latin_hypercube(30, 2, 1);
    const fit::GaussianProcess process(points, values_of(points, smooth));
    for (const fit::Point& point : fit::even_points(50, 2, 2))
    {
        EXPECT_NEAR(process.mean(point), smooth(point),
                    2e-2); // values span 4; worst in corners, where no point is near
    }
    EXPECT_GT(process.predictivity(), 0.999);
    EXPECT_LT(process.scatter(), 1e-2);
}

TEST(GaussianProcess, PolynomialsOfDegreeTwoAreExact)
{
    const auto quadratic = [](const fit::Point& u)
    { return 3.0 + u[0] - 2.0 * u[1] + u[0] * u[1] - 4.0 * u[1] * u[1]; };
    const std::vector<fit::Point> points = fit::latin_hypercube(15, 2, 3);
    std::vector<double> values;
    for (const fit::Point& point : points)
    {
        values.push_back(quadratic(point));
    }
    const fit::GaussianProcess process(points, values);
    for (const fit::Point& point : fit::even_points(20, 2, 4))
    {
        EXPECT_NEAR(process.mean(point), quadratic(point), 1e-6);
    }
}

TEST(GaussianProcess, ScatterIsToldFromShape)
{
    const std::vector<fit::Point> points = fit::latin_hypercube(120, 2, 5);
    fit::Random random(6);
    std::vector<double> values;
    for (const fit::Point& point : points)
    {
        values.push_back(smooth(point) + 0.1 * random.normal());
    }
    const fit::GaussianProcess process(points, values);
    EXPECT_NEAR(process.scatter(), 0.1, 0.02); // the standard deviation of 120 numbers is known to 6.5 %
    int within = 0;
    const std::vector<fit::Point> others = fit::even_points(400, 2, 7);
    for (const fit::Point& point : others)
    {
        const fit::GaussianProcess::Prediction one = process.predict(point);
        within += std::abs(smooth(point) + 0.1 * random.normal() - one.mean) < 1.645 * std::sqrt(one.variance) ? 1 : 0;
    }
    EXPECT_NEAR(within / 400.0, 0.9, 0.05); // three standard deviations of a share of 400
}

TEST(GaussianProcess, LeftOutErrorsAreThoseOfProcessesWithoutTheValue)
{
    // Without scatter and shape the same: a linear function with one value moved.
    std::vector<fit::Point> points = fit::latin_hypercube(12, 1, 8);
    std::vector<double> values = values_of(points, [](const fit::Point& u) { return 2.0 * u[0]; });
    const fit::GaussianProcess process(points, values);
    EXPECT_LT(process.left_out_errors().cwiseAbs().maxCoeff(), 1e-6);
}

TEST(GaussianProcess, ValuesThatAreAllTheSameAreThatValue)
{
    const std::vector<fit::Point> points = fit::latin_hypercube(10, 3, 9);
    const fit::GaussianProcess process(points, std::vector<double>(10, 4.5));
    EXPECT_EQ(process.mean(fit::Point{0.2, 0.3, 0.4}), 4.5);
    EXPECT_EQ(process.predictivity(), 1.0);
}

TEST(Design, LatinHypercubesHaveOnePointInEachPart)
{
    const std::vector<fit::Point> points = fit::latin_hypercube(16, 3, 11);
    for (std::size_t k = 0; k < 3; ++k)
    {
        std::vector<int> count(16, 0);
        for (const fit::Point& point : points)
        {
            ++count[static_cast<std::size_t>(point[k] * 16.0)];
        }
        EXPECT_EQ(count, std::vector<int>(16, 1));
    }
    EXPECT_EQ(points, fit::latin_hypercube(16, 3, 11));
    EXPECT_NE(points, fit::latin_hypercube(16, 3, 12));
}

} // namespace corticle
