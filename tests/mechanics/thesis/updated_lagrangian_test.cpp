// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanics/thesis/updated_lagrangian.hpp"

#include "corticle/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle::updated_lagrangian
{
namespace
{

constexpr double spacing = 0.1;
constexpr double mass = spacing * spacing; // density 1

/// Rows of particles, centred about the origin.
State plate(int columns, int rows)
{
    State state;
    for (int k = 0; k < columns * rows; ++k)
    {
        state.x.push_back(
            {spacing * (k % columns - 0.5 * (columns - 1)), spacing * (k / columns - 0.5 * (rows - 1)), 0});
    }
    state.v.resize(state.x.size());
    state.density.assign(state.x.size(), 1.0);
    state.S.resize(state.x.size());
    return state;
}

Vec3 total(std::span<const Vec3> vectors)
{
    Vec3 sum;
    for (const Vec3& v : vectors)
    {
        sum += v;
    }
    return sum;
}

/// First bending mode of a free beam from -1/2 to 1/2: cos(k x)/cos(k/2) + cosh(k x)/cosh(k/2), k = 4.7300.
double bending_mode(double x)
{
    constexpr double k = 4.730040744862704;
    return std::cos(k * x) / std::cos(0.5 * k) + std::cosh(k * x) / std::cosh(0.5 * k);
}

/// A free plate set swinging in its first bending mode comes to rest after a quarter of its period, which is
/// 2 pi / omega, omega = (k/L)² sqrt(E H² / (12 rho (1 - nu²))) for a thin plate (Landau & Lifshitz, Theory of
/// Elasticity).
TEST(UpdatedLagrangian, AFreePlateOscillatesWithThePeriodOfTheory)
{
    const Material material{.alpha = 0.0, .beta = 0.0};
    State state = plate(48, 6);
    const double L = 48 * spacing;
    const double H = 6 * spacing;
    const double K = 1.0;
    const double G = material.shear_modulus;
    const double E = 9.0 * K * G / (3.0 * K + G);
    const double nu = (3.0 * K - 2.0 * G) / (2.0 * (3.0 * K + G));
    const double omega = std::pow(4.730040744862704 / L, 2) * std::sqrt(E * H * H / (12.0 * (1.0 - nu * nu)));
    for (std::size_t i = 0; i < state.x.size(); ++i)
    {
        state.v[i].y = 0.001 * bending_mode(state.x[i].x / L);
    }
    const State start = state;
    const auto swing = [&]
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < state.x.size(); ++i)
        {
            sum += state.v[i].y * start.v[i].y;
        }
        return sum;
    };
    constexpr double dt = 0.05;
    double t = 0.0;
    for (; swing() > 0.0 && t < 2.0 * std::numbers::pi / omega; t += dt)
    {
        step(material, state, mass, dt);
    }
    // A plate eight times as long as thick swings some per cent slower than a thin one (shear, rotation), and six rows
    // whose kernel is cut at the faces bend more easily than the solid.
    const double over_theory = t / (0.5 * std::numbers::pi / omega);
    EXPECT_GT(over_theory, 1.0);
    EXPECT_LT(over_theory, 1.5);
    EXPECT_LT(norm(total(state.v) - total(start.v)), 1e-12);
}

TEST(UpdatedLagrangian, OnlyTheSymmetricPairsConserveMomentum)
{
    State state = plate(12, 10);
    for (std::size_t i = 0; i < state.x.size(); ++i)
    {
        state.v[i] = {0.1 * hash_uniform(1, i), 0.1 * hash_uniform(2, i), 0};
        state.density[i] = 1.0 + 0.05 * hash_uniform(3, i);
    }
    const Rates symmetric = rates({}, state, mass);
    const Rates printed = rates({.form = PairForm::printed}, state, mass);
    EXPECT_LT(norm(total(symmetric.v)), 1e-12);
    EXPECT_GT(norm(total(printed.v)), 1e-2);
}

/// A block that is compressed expands: at its corner the symmetric form pushes outward; the printed one, which sees no
/// difference of pressure, does nothing.
TEST(UpdatedLagrangian, DifferencesOfAnEvenPressurePushNothing)
{
    State state = plate(10, 10);
    state.density.assign(state.x.size(), 1.1);
    const Vec3 outward = normalized(state.x.back());
    EXPECT_GT(dot(rates({}, state, mass).v.back(), outward), 0.1);
    EXPECT_EQ(norm(rates({.form = PairForm::printed}, state, mass).v.back()), 0.0);
}

/// Viscosity must push apart what approaches. In eq. 6 it is added where it must be taken away.
TEST(UpdatedLagrangian, ThePrintedViscosityPullsTogetherWhatApproaches)
{
    State state;
    state.x = {{0, 0, 0}, {spacing, 0, 0}};
    state.v = {{0.1, 0, 0}, {-0.1, 0, 0}};
    state.density = {1.0, 1.0};
    state.S.resize(2);
    EXPECT_LT(rates({}, state, mass).v[0].x, 0.0);
    EXPECT_GT(rates({.form = PairForm::printed}, state, mass).v[0].x, 0.0);
}

/// Two blocks meet with opposite velocities; with the printed signs they do not part.
TEST(UpdatedLagrangian, CollidingBlocksBounceWithTheSignsPutRight)
{
    const auto separation = [](PairForm form)
    {
        State state = plate(12, 6);
        for (std::size_t i = 0; i < state.x.size(); ++i)
        {
            const double side = state.x[i].x < 0.0 ? -1.0 : 1.0;
            state.x[i].x += side * 0.15;
            state.v[i].x = -side * 0.05;
        }
        const Material material{.form = form};
        for (int k = 0; k < 500; ++k)
        {
            step(material, state, mass, 0.03);
        }
        double velocity = 0.0;
        for (std::size_t i = 0; i < state.x.size(); ++i)
        {
            const double side = i % 12 < 6 ? -1.0 : 1.0;
            velocity += side * state.v[i].x / static_cast<double>(state.x.size());
        }
        return velocity;
    };
    EXPECT_GT(separation(PairForm::symmetric), 0.01);
    EXPECT_FALSE(separation(PairForm::printed) > 0.01);
}

} // namespace
} // namespace corticle::updated_lagrangian
