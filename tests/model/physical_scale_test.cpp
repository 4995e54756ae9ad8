// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/physical_scale.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

Options options_from_23_weeks()
{
    Options options = test::sphere_options(2500);
    options.time.clock = GestationalClock::wang;
    options.time.start_week = 23.0;
    options.time.end_week = 38.0;
    options.time.start = growth_time(GestationalClock::wang, 23.0);
    options.time.end = growth_time(GestationalClock::wang, 38.0);
    options.size.law = LengthLaw::quadratic;
    return options;
}

/// The scale of a sphere stretched by `stretch` at 30 weeks.
PhysicalScale scale_at_30_weeks(const Options& options, double stretch = 1.0)
{
    const Model body = *test::small_model();
    Simulation simulation(test::shared(body), options);
    State state;
    state.motion.x = test::affine(body.cloud.positions, stretch * Mat3::identity());
    state.motion.v.resize(state.motion.x.size());
    state.t = growth_time(GestationalClock::wang, 30.0);
    simulation.restore(state);
    return physical_scale(simulation);
}

TEST(PhysicalScale, IsTheRatioOfLengthsAtTheTwoWeeks)
{
    Options options = options_from_23_weeks();
    const double ratio = brain_length(LengthLaw::quadratic, GestationalClock::wang, 30.0) /
                         brain_length(LengthLaw::quadratic, GestationalClock::wang, 23.0);
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).week, 30.0, 1e-12);
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).length, ratio, 1e-12); // the deformation comes on top
    options.size.applies_to = SizedState::body;
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).length, ratio / 1.2, 1e-12); // the deformed body has the length
    options.size.scaled = false;
    EXPECT_EQ(scale_at_30_weeks(options, 1.2).length, 1.0);
    EXPECT_EQ(test::largest_norm(scaled(std::vector<Vec3>{{1, 0, 0}, {0, -2, 0}}, 1.5)), 3.0);
}

TEST(PhysicalScale, IsOneAtTheStartAndWithoutAClock)
{
    const Model body = *test::small_model();
    const Options with = options_from_23_weeks();
    const Simulation simulation(test::shared(body), with);
    EXPECT_EQ(simulation.state().t, with.time.start);
    EXPECT_EQ(physical_scale(simulation).week, 23.0);
    EXPECT_EQ(physical_scale(simulation).length, 1.0);
    const Options without = test::sphere_options(2500);
    const Simulation plain(test::shared(body), without);
    EXPECT_TRUE(std::isnan(physical_scale(plain).week));
    EXPECT_EQ(physical_scale(plain).length, 1.0);
}

TEST(LateStart, TheBodyAsImagedIsStressFreeAndThenGrows)
{
    Options options = options_from_23_weeks();
    options.geometry.particles = 2500;
    options.tissue.thickness_mm = 2.5;
    options.size.thin_cortex = true;
    Model body = prepare_body(options).model;
    EXPECT_TRUE(layer_moves(body.tissue, options.tissue, cortex_size(options))); // it thins
    Simulation simulation(test::shared(body), options);
    EXPECT_FALSE(simulation.state().nodes.past.empty());
    EXPECT_LT(std::abs(simulation.internal().elastic_energy), 1e-9);
    for (int k = 0; k < 20; ++k)
    {
        simulation.step(options.time.end);
    }
    EXPECT_GT(simulation.internal().elastic_energy, 1e-3);
}

} // namespace
} // namespace corticle
