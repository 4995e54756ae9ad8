// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

/// A mass on a spring, pulled out along (1, 2, 2) / 3 and let go.
struct Oscillator
{
    double mass = 2.0;
    double stiffness = 3.0;
    double damping = 0.0;
    dynamics::Motion motion;
    double damped = 0.0;

    Oscillator()
    {
        motion.x.assign(1, Vec3{1, 2, 2} / 3.0);
        motion.v.resize(1);
        motion.force.resize(1);
    }

    double potential() const { return 0.5 * stiffness * squared_norm(motion.x[0]); }

    dynamics::StepEnergies step(double dt)
    {
        motion.force[0] = -stiffness * motion.x[0];
        dynamics::Motion next = motion;
        const dynamics::StepEnergies energies = dynamics::advance(motion, std::vector{mass}, dt, {damping}, next);
        motion = next;
        damped += energies.damped;
        return energies;
    }
};

/// Distance from the exact position of the damped oscillator after six units of time.
double error_after(double dt)
{
    Oscillator oscillator;
    oscillator.damping = 0.3;
    const int steps = static_cast<int>(std::lround(6.0 / dt));
    for (int k = 0; k < steps; ++k)
    {
        oscillator.step(dt);
    }
    // x'' = -w² x - gamma x', x(0) = 1, x'(0) = 0.
    const double half = 0.5 * oscillator.damping;
    const double w = std::sqrt(oscillator.stiffness / oscillator.mass - half * half);
    const double exact = std::exp(-half * 6.0) * (std::cos(w * 6.0) + half / w * std::sin(w * 6.0));
    return norm(oscillator.motion.x[0] - exact * (Vec3{1, 2, 2} / 3.0));
}

TEST(Advance, ConvergesToTheDampedOscillatorWithTheFirstPowerOfTheStep)
{
    const double coarse = error_after(0.01);
    const double fine = error_after(0.005);
    EXPECT_LT(coarse, 0.01);
    EXPECT_NEAR(coarse / fine, 2.0, 0.1);
}

TEST(Advance, KeepsTheInvariantOfSymplecticEuler)
{
    Oscillator oscillator;
    const double dt = 0.1;
    // m v² / 2 + k x² / 2 - dt k x v / 2 is conserved exactly by v' = v - dt k x / m, x' = x + dt v'.
    const auto invariant = [&]
    {
        const dynamics::Motion& m = oscillator.motion;
        return 0.5 * oscillator.mass * squared_norm(m.v[0]) + oscillator.potential() -
               0.5 * dt * oscillator.stiffness * dot(m.x[0], m.v[0]);
    };
    const double at_start = invariant();
    for (int k = 0; k < 10000; ++k)
    {
        oscillator.step(dt);
    }
    EXPECT_NEAR(invariant() / at_start, 1.0, 1e-12); // 10,000 round-offs
}

TEST(Advance, DampingDecaysExactlyWhateverTheStep)
{
    dynamics::Motion motion{{Vec3{1, 2, 3}}, {Vec3{4, -5, 6}}, {Vec3{}}};
    dynamics::Motion next = motion;
    double damped = 0.0;
    for (const double dt : {0.1, 2.0, 0.4})
    {
        damped += dynamics::advance(motion, std::vector{1.5}, dt, {0.8}, next).damped;
        motion = next;
    }
    const Vec3 expected = std::exp(-0.8 * 2.5) * Vec3{4, -5, 6};
    EXPECT_LT(norm(motion.v[0] - expected), 1e-14);
    EXPECT_NEAR(damped, 0.5 * 1.5 * (77.0 - squared_norm(expected)), 1e-12);
}

TEST(Advance, AMediumThatExpandsCarriesAlong)
{
    const std::vector<double> mass{2.0, 0.5};
    dynamics::Motion now{{Vec3{3, 0, 0}, Vec3{1, -4, 2}}, {Vec3{0.1, 0, 0.3}, Vec3{}}, {Vec3{}, Vec3{0, 1, 0}}};
    dynamics::Motion next = now;
    const dynamics::Medium medium{0.9, 0.02, {1, 1, 1}};
    const double dt = 0.05;
    const double before = dynamics::kinetic_energies(now, mass, medium).whole;
    const dynamics::StepEnergies energies = dynamics::advance(now, mass, dt, medium, next);
    double work = 0.0; // of the force over the kick, before the drag
    for (std::size_t i = 0; i < mass.size(); ++i)
    {
        const Vec3 u = 0.02 * (now.x[i] - Vec3{1, 1, 1});
        const Vec3 driven = now.v[i] + (dt / mass[i]) * now.force[i];
        EXPECT_LT(norm(next.v[i] - (u + std::exp(-0.9 * dt) * (driven - u))), 1e-15);
        work += 0.5 * mass[i] * (squared_norm(driven) - squared_norm(now.v[i]));
    }
    EXPECT_NEAR(before + work + energies.carried, energies.kinetic + energies.damped, 1e-14);
    EXPECT_GT(energies.damped, 0.0);
}

TEST(Advance, WhatMovesAsTheMediumKeepsItsSpeed)
{
    dynamics::Motion now{{Vec3{3, 0, 0}}, {Vec3{0.04, -0.02, -0.02}}, {Vec3{}}};
    dynamics::Motion next = now;
    const dynamics::StepEnergies energies =
        dynamics::advance(now, std::vector{2.0}, 0.1, {50.0, 0.02, {1, 1, 1}}, next);
    EXPECT_LT(norm(next.v[0] - now.v[0]), 1e-16);
    EXPECT_NEAR(energies.relative, 0.0, 1e-30);
    EXPECT_NEAR(energies.damped, 0.0, 1e-30);
}

TEST(Advance, TellsTheLongestWay)
{
    const dynamics::Motion motion{{Vec3{}, Vec3{}}, {Vec3{3, 0, 4}, Vec3{0, -1, 0}}, {Vec3{}, Vec3{}}};
    dynamics::Motion next = motion;
    EXPECT_NEAR(dynamics::advance(motion, std::vector{2.0, 2.0}, 0.1, {}, next).longest, 0.5, 1e-15);
}

TEST(Advance, EnergyBalanceBalance)
{
    Oscillator oscillator;
    oscillator.damping = 0.4;
    const double at_start = oscillator.potential();
    const double dt = 1e-3;
    double kinetic = 0.0;
    for (int k = 0; k < 3000; ++k)
    {
        kinetic = oscillator.step(dt).kinetic;
    }
    EXPECT_GT(oscillator.damped, 0.5 * at_start);
    // The invariant differs from the energy by dt w / 2 of it, under 0.1 %.
    EXPECT_NEAR((kinetic + oscillator.potential() + oscillator.damped) / at_start, 1.0, 2e-3);
}

TEST(CriticalStep, IsTheShareOfTheTimeAWaveTakesPerSpacing)
{
    EXPECT_DOUBLE_EQ(dynamics::critical_step(0.25, 0.6, 3.0), 0.05);
}

} // namespace
} // namespace corticle
