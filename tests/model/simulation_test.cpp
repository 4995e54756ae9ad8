// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/version.hpp"
#include "corticle/record/checkpointing.hpp"
#include "formats/temporary_folder.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using test::expect_same_bits;
using test::rough_start;
using test::take_steps;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(Simulation, OneAndTwoThreadsGiveTheSameBits)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    const int threads = thread_count();
    set_thread_count(1);
    model::Simulation one(test::shared(body), options);
    one.restore(rough_start(body, 0.05));
    take_steps(one, 50);
    set_thread_count(2);
    model::Simulation two(test::shared(body), options);
    two.restore(rough_start(body, 0.05));
    take_steps(two, 50);
    set_thread_count(threads);
    EXPECT_GT(one.state().loading_rate, 1.0);
    expect_same_bits(one, two);
}

TEST(Simulation, GoesOnFromACheckpointToTheSameBits)
{
    config::Options options = test::sphere_options(2500);
    options.tissue.thickness_rate_mm = 0.4; // theta follows t
    options.contact.distance = 0.6;         // and contact is at work
    const model::Model& body = *test::small_model();
    model::Simulation whole(test::shared(body), options);
    whole.restore(rough_start(body, 0.2));
    take_steps(whole, 25);
    EXPECT_GT(whole.contact().active, 0);
    std::vector<metrics::Measures> rows(2);
    rows[1].area_mm2 = 17.25;
    const record::Checkpoint checkpoint = record::to_checkpoint(whole.state(), rows, "case");
    EXPECT_GT(whole.state().loading_rate, 1.0);
    take_steps(whole, 25);

    const record::Restored restored = record::from_checkpoint(checkpoint, body.cloud.positions.size(), "checkpoint.h5");
    ASSERT_EQ(restored.rows.size(), 2u);
    EXPECT_EQ(restored.rows[1].area_mm2, 17.25);
    model::Simulation resumed(test::small_model(), options);
    resumed.restore(restored.state);
    take_steps(resumed, 25);
    expect_same_bits(whole, resumed);
    EXPECT_EQ(whole.state().rejected_steps, resumed.state().rejected_steps);
    EXPECT_EQ(whole.state().onset_t, resumed.state().onset_t);
}

TEST(Simulation, ACheckpointOfAnotherBodyIsRefused)
{
    model::State state;
    state.motion.x.resize(10);
    state.motion.v.resize(10);
    EXPECT_THROW(record::from_checkpoint(record::to_checkpoint(state, {}, "case"), 11, "checkpoint.h5"), InputError);
    EXPECT_THROW(record::from_checkpoint({}, 10, "checkpoint.h5"), InputError);
}

TEST(Simulation, ACheckpointOfAnotherLayoutIsRefusedWithTheVersionThatWroteIt)
{
    model::State state;
    state.motion.x.resize(10);
    state.motion.v.resize(10);
    const std::vector<metrics::Measures> rows(2);
    const record::Checkpoint whole = record::to_checkpoint(state, rows, "case", "0.0.7 (abc)");
    EXPECT_EQ(record::reached_time(whole, "checkpoint.h5"), 0.0);
    record::Checkpoint shorter_clock = whole;
    shorter_clock.scalars["clock"].pop_back();
    record::Checkpoint fewer_columns = whole;
    fewer_columns.scalars.erase("measures.volume_mm3");
    record::Checkpoint fewer_counters = whole;
    fewer_counters.integers["counters"].pop_back();
    for (const record::Checkpoint& other : {shorter_clock, fewer_columns, fewer_counters})
    {
        const std::string message = message_of<InputError>([&] { record::reached_time(other, "checkpoint.h5"); });
        EXPECT_THAT(message, HasSubstr("checkpoint.h5: "));
        EXPECT_THAT(message,
                    ContainsRegex("that version 0.0.7 \\(abc\\) wrote .*; got [038] values of [a-z_.0-9]+; expected "));
        EXPECT_THAT(message, HasSubstr(", as version " + std::string(program_version()) + " writes them"));
    }
}

TEST(Simulation, TakesBackAStepThatInvertsAParticleAndGoesOn)
{
    config::Options options = test::sphere_options(2500);
    options.contact.enabled = false;
    options.dynamics.cfl = 5.0; // far beyond stability
    options.dynamics.max_halvings = 30;
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    simulation.restore(rough_start(body, 0.1));
    take_steps(simulation, 60);
    EXPECT_GT(simulation.state().rejected_steps, 0);
    EXPECT_EQ(simulation.state().steps, 60);
    EXPECT_LE(simulation.state().step_scale, 1.0);
    EXPECT_GT(simulation.internal().smallest_J, 0.0);
    for (const Vec3& x : simulation.state().motion.x)
    {
        ASSERT_TRUE(is_finite(x));
    }
}

/// Steps taken back again and again, with some accepted between them, never come to max_halvings in a row.
TEST(Simulation, AStepThatHasCollapsedEndsTheRunWithADiagnosis)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    model::State state = rough_start(body, 0.05);
    state.step_scale = 1e-6;
    state.rejected_steps = 1234;
    simulation.restore(state);
    const std::string message = message_of<RunError>([&] { simulation.step(1.0); });
    EXPECT_THAT(message, HasSubstr("the step has collapsed at step 1"));
    EXPECT_THAT(message, HasSubstr("1234 steps taken back so far"));
    EXPECT_THAT(message, ContainsRegex("most compressed: particle [0-9]+: position"));
}

TEST(Simulation, AStepThatContactMakesTooShortNamesThePair)
{
    config::Options options = test::sphere_options(2500);
    options.contact.distance = 2.0; // every vertex and edge has neighbours within
    options.contact.stiffness = 1e14;
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    model::State state = rough_start(body, 0.0);
    for (Vec3& x : state.motion.x)
    {
        x *= 0.99; // closer than at rest
    }
    simulation.restore(state);
    const std::string message = message_of<RunError>([&] { simulation.step(1.0); });
    EXPECT_THAT(message, HasSubstr("the step has collapsed at step 1"));
    EXPECT_THAT(message, ContainsRegex("stiffest contact: (particle [0-9]+ and the triangle of|particles [0-9]+ and "
                                       "[0-9]+ and the edge of) particles [0-9, ]+.*: distance [0-9.e-]+ mm, repels "
                                       "below [0-9.e-]+ mm, at \\("));
    EXPECT_THAT(message, Not(HasSubstr("most compressed")));
}

/// A crushed body, whose rate has no bound: no endless loop of steps of no length.
TEST(Simulation, ABodyCrushedToNothingEndsTheRun)
{
    config::Options options = test::sphere_options(2500);
    options.contact.enabled = false;
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    model::State state = rough_start(body, 0.0);
    for (Vec3& x : state.motion.x)
    {
        x *= 1e-40;
    }
    EXPECT_THROW(
        {
            simulation.restore(state);
            simulation.step(1.0);
        },
        RunError);
}

TEST(Simulation, GivesUpWithADiagnosis)
{
    config::Options options = test::sphere_options(2500);
    options.contact.enabled = false;
    options.dynamics.cfl = 5.0;
    options.dynamics.max_halvings = 0;
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    simulation.restore(rough_start(body, 0.1));
    try
    {
        take_steps(simulation, 200);
        FAIL() << "no step failed";
    }
    catch (const RunError& error)
    {
        using testing::HasSubstr;
        EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("particle "), HasSubstr("step "), HasSubstr("t = "),
                                                 HasSubstr("J = "), HasSubstr("F = "), HasSubstr(" neighbours")));
        EXPECT_THAT(error.what(), HasSubstr(std::to_string(simulation.state().steps + 1)));
    }
}

TEST(Simulation, AnInvertedStartIsRefused)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    model::State state = rough_start(body, 0.0);
    state.motion.x = test::affine(state.motion.x, Mat3::diagonal(1, 1, -1));
    EXPECT_THROW(simulation.restore(state), RunError);
}

TEST(Simulation, StopsAtTheTimeItIsToldTo)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    const double t_stop = 2.5 * simulation.step_size();
    int steps = 0;
    for (; simulation.state().t < t_stop; ++steps)
    {
        simulation.step(t_stop);
    }
    EXPECT_EQ(simulation.state().t, t_stop);
    EXPECT_EQ(steps, 3);
}

TEST(Simulation, LoadingTimeIsCountedInCrossingsOfTheBody)
{
    config::Options options = test::sphere_options(2500);
    options.dynamics.loading_time = 40.0;
    const model::Model body = *test::small_model();
    const model::Simulation simulation(test::shared(body), options);
    // T = 40 R / c_p with c_p = sqrt(5 + 4/3) at density 1; R from the particles' volumes, which sum to the sphere's.
    EXPECT_NEAR(simulation.total_time() / (40.0 * 12.496 / std::sqrt(5.0 + 4.0 / 3.0)), 1.0, 1e-9);
}

TEST(Simulation, LoadsFasterOnceFoldsHaveAppeared)
{
    config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    while (simulation.state().t < 0.17)
    {
        simulation.step(0.17);
    }
    EXPECT_EQ(simulation.state().loading_rate, 1.0);

    model::State folded = simulation.state();
    folded.onset_t = 0.17;
    simulation.restore(folded);
    double last = 1.0;
    while (simulation.state().t < 0.27)
    {
        simulation.step(0.27);
        const double rate = simulation.state().loading_rate;
        ASSERT_NEAR(rate / last, 1.0, 0.05); // no jolts
        ASSERT_LE(rate, options.dynamics.fastest_loading);
        last = rate;
    }
    EXPECT_GT(last, 1.5);
    const double step_in_t = simulation.step_size();

    model::State snapping = simulation.state();
    for (Vec3& v : snapping.motion.v)
    {
        v = 10.0 * v;
    }
    simulation.restore(snapping);
    EXPECT_EQ(simulation.step_size(), step_in_t);
    take_steps(simulation, 10);
    EXPECT_LT(simulation.state().loading_rate, last);

    options.dynamics.fastest_loading = 1.0;
    model::Simulation constant(test::shared(body), options);
    constant.restore(folded);
    take_steps(constant, 10);
    EXPECT_EQ(constant.state().loading_rate, 1.0);
}

} // namespace
} // namespace corticle
