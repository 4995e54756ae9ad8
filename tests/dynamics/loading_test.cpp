// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/loading.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

constexpr double growth_step = 1e-3;

/// The rate at t_end when nothing folds. @param rate  at t
double unfolded_rate(const dynamics::Loading& loading, double rate, double t, double t_end)
{
    for (; t < t_end; t += growth_step)
    {
        rate = loading.next({rate, t + growth_step, growth_step, false, 0.0, 0.0});
    }
    return rate;
}

TEST(Loading, PassesTheGrowthAtWhichAFlatCortexFoldsSlowly)
{
    const dynamics::DynamicsOptions dynamics;
    const dynamics::Loading loading(dynamics, {}, 0.0);
    // A flat layer of the default tissue folds at g = 1.3805, t = 0.208; the sphere of the thesis at t = 0.241.
    EXPECT_FALSE(loading.is_critical(0.17));
    EXPECT_TRUE(loading.is_critical(0.208));
    EXPECT_TRUE(loading.is_critical(0.241));
    EXPECT_FALSE(loading.is_critical(0.31));
    EXPECT_EQ(unfolded_rate(loading, 1.0, 0.0, 0.17), 1.0);
    EXPECT_NEAR(unfolded_rate(loading, 1.0, 0.0, 0.24), dynamics.slowest_loading, 0.01);
    EXPECT_NEAR(unfolded_rate(loading, 1.0, 0.0, 0.4), 1.0, 0.01);
}

TEST(Loading, CountsGrowthSinceTheBodyWasFreeOfStress)
{
    material::TissueOptions tissue;
    tissue.alpha_t = 2.0;
    EXPECT_TRUE(dynamics::Loading({}, tissue, 0.0).is_critical(0.2));
    // (1 + 2 t) / 1.4 = 1.4 at t = 0.48
    EXPECT_FALSE(dynamics::Loading({}, tissue, 0.2).is_critical(0.2));
    EXPECT_TRUE(dynamics::Loading({}, tissue, 0.2).is_critical(0.48));
    tissue.alpha_white = 2.0; // both grow alike: nothing to fold
    const dynamics::Loading alike({}, tissue, 0.0);
    for (double t = 0.0; t <= 1.0; t += 0.01)
    {
        EXPECT_FALSE(alike.is_critical(t));
    }
}

TEST(Loading, FollowsTheKineticEnergyOnceFoldsHaveAppeared)
{
    const dynamics::DynamicsOptions dynamics;
    const dynamics::Loading loading(dynamics, {}, 0.0);
    const auto after = [&](double rate, double kinetic)
    {
        for (int step = 0; step < 1000; ++step)
        {
            rate = loading.next({rate, 0.25, growth_step, true, kinetic, 1000.0});
        }
        return rate;
    };
    EXPECT_NEAR(after(0.25, 1e-6), dynamics.fastest_loading, 1e-6);
    EXPECT_NEAR(after(3.0, 1e3), 1.0, 1e-6);
    EXPECT_NEAR(after(2.0, 1.0), 2.0, 1e-12); // 0.1 %, what is aimed at
}

TEST(Loading, KeepsAFixedStepAndMayBeTurnedOff)
{
    dynamics::DynamicsOptions dynamics;
    dynamics.slowest_loading = 1.0;
    dynamics.fastest_loading = 1.0;
    const dynamics::Loading constant(dynamics, {}, 0.0);
    EXPECT_EQ(unfolded_rate(constant, 1.0, 0.0, 0.24), 1.0);
    EXPECT_EQ(constant.next({1.0, 0.3, growth_step, true, 1e-9, 1.0}), 1.0);
    dynamics = {};
    dynamics.time_step = 1e-4;
    EXPECT_EQ(unfolded_rate(dynamics::Loading(dynamics, {}, 0.0), 1.0, 0.0, 0.24), 1.0);
}

} // namespace
} // namespace corticle
