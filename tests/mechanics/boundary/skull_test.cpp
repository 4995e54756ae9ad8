// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/skull_term.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/metrics/measures.hpp"
#include "corticle/record/checkpointing.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using boundary::SkullKind;
using boundary::SkullShape;

/// A sphere of 12.496 mm in a skull at this distance.
config::Options in_skull(double offset, SkullKind kind = SkullKind::rigid)
{
    config::Options options = test::sphere_options(2500);
    options.boundary.shape = SkullShape::offset;
    options.boundary.offset_mm = offset;
    options.dynamics.cfl = 0.15; // a whole sphere that meets its skull at once rings in long steps
    options.boundary.kind = kind;
    return options;
}

std::shared_ptr<const model::Model> model_of(const config::Options& options)
{
    model::Model model = *test::small_model();
    model.skull = prepare::prepare_body(options).model.skull;
    return test::shared(model);
}

double balance_of(const model::Simulation& simulation)
{
    const model::State& state = simulation.state();
    double stored = state.kinetic_energy + state.energy_balance.dissipated;
    for (const auto& [name, value] : simulation.energies())
    {
        stored += value;
    }
    return stored / state.energy_balance.growth_work;
}

metrics::BoundaryMeasures measured(const model::Simulation& simulation)
{
    return metrics::boundary_measures(model::output_view(simulation));
}

TEST(SkullGrowth, IsLinearBetweenItsTimes)
{
    const std::vector<double> times{0.2, 0.6};
    const std::vector<double> scales{1.0, 1.2};
    const boundary::SkullGrowth growth(times, scales);
    EXPECT_EQ(growth.scale(0.0), 1.0);
    EXPECT_DOUBLE_EQ(growth.scale(0.4), 1.1);
    EXPECT_EQ(growth.scale(1.0), 1.2);
    EXPECT_EQ(growth.rate(0.1), 0.0);
    EXPECT_DOUBLE_EQ(growth.rate(0.2), 0.5);
    EXPECT_EQ(growth.rate(0.6), 0.0);
    EXPECT_EQ(boundary::SkullGrowth().scale(0.3), 1.0);
    EXPECT_EQ(boundary::SkullGrowth().rate(0.3), 0.0);
}

TEST(Skull, FarAwayItChangesNothing)
{
    config::Options free = test::sphere_options(2500);
    free.dynamics.cfl = 0.15;
    free.contact.distance = 0.6;
    config::Options enclosed = in_skull(30.0);
    enclosed.contact.distance = 0.6;
    model::State rough;
    rough.motion.x = test::perturbed(test::small_model()->cloud.positions, 0.2 * test::small_model()->cloud.spacing);
    rough.motion.v.resize(rough.motion.x.size());
    model::Simulation alone(test::small_model(), free);
    model::Simulation within(model_of(enclosed), enclosed);
    alone.restore(rough);
    within.restore(rough);
    test::take_steps(alone, 40);
    test::take_steps(within, 40);
    EXPECT_GT(alone.contact().active, 0);
    test::expect_same_bits(alone, within);
}

void expect_confined(SkullKind kind)
{
    config::Options options = in_skull(0.5, kind);
    options.boundary.stiffness = 5.0;
    model::Simulation simulation(model_of(options), options);
    double least_force = 0.0;
    for (const double t : {0.15, 0.3, 0.45})
    {
        while (simulation.state().t < t)
        {
            simulation.step(t);
        }
        const metrics::BoundaryMeasures m = measured(simulation);
        EXPECT_EQ(m.skull_intersections, 0.0) << t;
        EXPECT_GE(m.skull_force, least_force) << t; // the more it grows
        least_force = m.skull_force;
    }
    const metrics::BoundaryMeasures m = measured(simulation);
    EXPECT_GT(m.skull_contact_share, 0.2);
    EXPECT_GT(m.energy_skull, 0.0);
    EXPECT_NEAR(balance_of(simulation), 1.0, 0.01);
    const model::Model& model = simulation.model();
    const double own = enclosed_volume(simulation.surface_positions(), model.cloud.surface_triangles);
    EXPECT_LT(own, m.skull_volume_mm3);
}

TEST(Skull, ABrainFillsARigidOneAndDoesNotCrossIt)
{
    expect_confined(SkullKind::rigid);
}

TEST(Skull, ABrainPushesAnElasticOneAndDoesNotCrossIt)
{
    expect_confined(SkullKind::elastic);
}

TEST(Skull, WorkOfOneThatShrinksCountsAsWork)
{
    config::Options options = in_skull(0.5);
    options.tissue.alpha_t = 0.0;
    options.boundary.times = {0.0, 0.5};
    options.boundary.scales = {1.0, 0.94};
    model::Simulation simulation(model_of(options), options);
    while (simulation.state().t < 0.5)
    {
        simulation.step(0.5);
    }
    const metrics::BoundaryMeasures m = measured(simulation);
    EXPECT_EQ(m.skull_intersections, 0.0);
    EXPECT_GT(simulation.internal().elastic_energy, 0.0);
    EXPECT_NEAR(balance_of(simulation), 1.0, 0.01);
}

TEST(Skull, ThreadsAndResumptionsGiveTheSameBits)
{
    config::Options options = in_skull(0.15, SkullKind::elastic);
    options.boundary.fluid = boundary::Fluid::conserved;
    options.boundary.times = {0.0, 1.0};
    options.boundary.scales = {1.0, 1.1};
    const auto model = model_of(options);
    const int threads = thread_count();
    set_thread_count(1);
    model::Simulation one(model, options);
    test::take_steps(one, 120);
    set_thread_count(2);
    model::Simulation two(model, options);
    test::take_steps(two, 60);
    const record::Checkpoint checkpoint = record::to_checkpoint(two.state(), {}, "case");
    model::Simulation resumed(model, options);
    resumed.restore(record::from_checkpoint(checkpoint, model->cloud.positions.size(), "checkpoint.h5").state);
    test::take_steps(resumed, 60);
    set_thread_count(threads);
    EXPECT_GT(one.contact().active, 0);
    test::expect_same_bits(one, resumed);
    EXPECT_EQ(one.state().history, resumed.state().history);
}

TEST(Skull, ThatDoesNotEncloseTheBodyIsRefused)
{
    config::Options options = in_skull(1.0);
    options.boundary.shape = SkullShape::ellipsoid;
    options.boundary.semi_axes_mm = {20.0, 20.0, 12.0};
    EXPECT_THAT([&] { prepare::prepare_body(options); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("the skull does not enclose the body")));
}

} // namespace
} // namespace corticle
