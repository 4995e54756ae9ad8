// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle::test
{

/// Positions a little rough, so that no symmetry hides anything; folds are said to be there, so that the loading is
/// free.
inline model::State rough_start(const model::Model& body, double amplitude)
{
    model::State state;
    state.motion.x = test::perturbed(body.cloud.positions, amplitude * body.cloud.spacing);
    state.motion.v.resize(state.motion.x.size());
    state.onset_t = 0.0;
    state.loading_rate = 2.0;
    return state;
}

inline void take_steps(model::Simulation& simulation, int count)
{
    for (int k = 0; k < count; ++k)
    {
        simulation.step(1.0);
    }
}

inline void expect_same_bits(const model::Simulation& a, const model::Simulation& b)
{
    EXPECT_EQ(a.state().motion.x, b.state().motion.x);
    EXPECT_EQ(a.state().motion.v, b.state().motion.v);
    EXPECT_EQ(a.state().motion.force, b.state().motion.force);
    EXPECT_EQ(a.state().t, b.state().t);
    EXPECT_EQ(a.state().steps, b.state().steps);
    EXPECT_EQ(a.state().step_scale, b.state().step_scale);
    EXPECT_EQ(a.state().kinetic_energy, b.state().kinetic_energy);
    EXPECT_EQ(a.state().energy_balance.growth_work, b.state().energy_balance.growth_work);
    EXPECT_EQ(a.state().energy_balance.dissipated, b.state().energy_balance.dissipated);
    EXPECT_EQ(a.state().lowest_gi_sphere, b.state().lowest_gi_sphere);
    EXPECT_EQ(a.state().loading_rate, b.state().loading_rate);
    EXPECT_EQ(a.step_size(), b.step_size());
    EXPECT_EQ(a.internal().elastic_energy, b.internal().elastic_energy);
    EXPECT_EQ(a.contact().active, b.contact().active);
}

} // namespace corticle::test
