// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/physical_scale.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

config::Options options_from_23_weeks()
{
    config::Options options = test::sphere_options(2500);
    options.time.clock = material::GestationalClock::wang;
    options.time.start_week = 23.0;
    options.time.end_week = 38.0;
    options.time.start = material::growth_time(material::GestationalClock::wang, 23.0);
    options.time.end = material::growth_time(material::GestationalClock::wang, 38.0);
    options.size.law = material::LengthLaw::quadratic;
    return options;
}

/// The scale of a sphere stretched by `stretch` at 30 weeks.
model::PhysicalScale scale_at_30_weeks(const config::Options& options, double stretch = 1.0)
{
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    model::State state;
    state.motion.x = test::affine(body.cloud.positions, stretch * Mat3::identity());
    state.motion.v.resize(state.motion.x.size());
    state.t = material::growth_time(material::GestationalClock::wang, 30.0);
    simulation.restore(state);
    return model::physical_scale(simulation);
}

TEST(PhysicalScale, IsTheRatioOfLengthsAtTheTwoWeeks)
{
    config::Options options = options_from_23_weeks();
    const double ratio =
        material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::wang, 30.0) /
        material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::wang, 23.0);
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).week, 30.0, 1e-12);
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).length, ratio, 1e-12); // the deformation comes on top
    options.size.applies_to = material::SizedState::body;
    EXPECT_NEAR(scale_at_30_weeks(options, 1.2).length, ratio / 1.2, 1e-12); // the deformed body has the length
    options.size.scaled = false;
    EXPECT_EQ(scale_at_30_weeks(options, 1.2).length, 1.0);
    EXPECT_EQ(test::largest_norm(model::scaled(std::vector<Vec3>{{1, 0, 0}, {0, -2, 0}}, 1.5)), 3.0);
}

TEST(PhysicalScale, IsOneAtTheStartAndWithoutAClock)
{
    const model::Model body = *test::small_model();
    const config::Options with = options_from_23_weeks();
    const model::Simulation simulation(test::shared(body), with);
    EXPECT_EQ(simulation.state().t, with.time.start);
    EXPECT_EQ(model::physical_scale(simulation).week, 23.0);
    EXPECT_EQ(model::physical_scale(simulation).length, 1.0);
    const config::Options without = test::sphere_options(2500);
    const model::Simulation plain(test::shared(body), without);
    EXPECT_TRUE(std::isnan(model::physical_scale(plain).week));
    EXPECT_EQ(model::physical_scale(plain).length, 1.0);
}

TEST(LateStart, TheBodyAsImagedIsStressFreeAndThenGrows)
{
    config::Options options = options_from_23_weeks();
    options.geometry.particles = 2500;
    options.tissue.thickness_mm = 2.5;
    options.size.thin_cortex = true;
    model::Model body = prepare::prepare_body(options).model;
    EXPECT_TRUE(material::layer_moves(body.tissue, options.tissue, model::cortex_size(options))); // it thins
    model::Simulation simulation(test::shared(body), options);
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
