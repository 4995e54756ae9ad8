// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/runge_kutta.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

/// x'' = -4 x - 0.6 x' + sin t from x = 1, x' = 0, by `steps` steps to t = 2.
double oscillator_at_two(int steps)
{
    const std::vector<double> mass{0.5};
    const double damping = 0.6;
    const double dt = 2.0 / steps;
    const auto force = [&](dynamics::Motion& motion, double t) {
        motion.force[0] = (0.5 * (std::sin(t) - 4.0 * motion.x[0].x)) * Vec3{1, 0, 0};
    };
    dynamics::Motion now{{{1, 0, 0}}, {{}}, {{}}};
    dynamics::Motion next = now;
    dynamics::RungeKutta4 method;
    force(now, 0.0);
    for (int k = 0; k < steps; ++k)
    {
        const auto evaluate = [&](dynamics::Motion& stage, double part)
        {
            force(stage, (k + part) * dt);
            return true;
        };
        EXPECT_TRUE(method.advance(now, mass, dt, {damping}, evaluate, next));
        force(next, (k + 1) * dt);
        std::swap(now, next);
    }
    return now.x[0].x;
}

TEST(RungeKutta4, IsOfFourthOrder)
{
    const double fine = oscillator_at_two(640);
    const double coarse_error = oscillator_at_two(20) - fine;
    const double half_error = oscillator_at_two(40) - fine;
    EXPECT_NEAR(coarse_error / half_error, 16.0, 1.0);
    EXPECT_LT(std::abs(half_error), 1e-5);
}

TEST(RungeKutta4, EnergyBalanceInAMediumThatExpands)
{
    const std::vector<double> mass{0.5};
    const dynamics::Medium medium{0.6, 0.1, {-2, 0, 0}};
    const auto spring = [](dynamics::Motion& motion) { motion.force[0] = -2.0 * motion.x[0]; };
    dynamics::Motion now{{{1, 0, 0}}, {{}}, {{}}};
    dynamics::Motion next = now;
    dynamics::RungeKutta4 method;
    spring(now);
    double damped = 0.0;
    double carried = 0.0;
    for (int k = 0; k < 1000; ++k)
    {
        const auto evaluate = [&](dynamics::Motion& stage, double)
        {
            spring(stage);
            return true;
        };
        const auto energies = method.advance(now, mass, 0.005, medium, evaluate, next);
        ASSERT_TRUE(energies);
        damped += energies->damped;
        carried += energies->carried;
        spring(next);
        std::swap(now, next);
    }
    const double stored = squared_norm(now.x[0]) + dynamics::kinetic_energies(now, mass, medium).whole;
    EXPECT_NEAR(1.0 + carried, stored + damped, 1e-4);
    EXPECT_GT(std::abs(carried), 0.01);
}

TEST(RungeKutta4, StopsAtAStageThatIsInvalid)
{
    dynamics::Motion now{{{1, 0, 0}}, {{}}, {{}}};
    dynamics::Motion next = now;
    int calls = 0;
    const auto evaluate = [&](dynamics::Motion&, double) { return ++calls < 2; };
    EXPECT_FALSE(dynamics::RungeKutta4().advance(now, std::vector<double>{1.0}, 0.1, {}, evaluate, next));
    EXPECT_EQ(calls, 2);
}

} // namespace
} // namespace corticle
