// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/parameters/options.hpp"
#include "corticle/prepare/prepare.hpp"
#include "corticle/record/checkpointing.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

config::Options printed_case(std::vector<std::string> overrides = {})
{
    overrides.insert(overrides.begin(), {"geometry.particles=1500", "solver.time_step=1e-4"});
    return config::parse_case("[solver]\nformulation = \"thesis\"\n", "case.toml", overrides, "");
}

using test::expect_same_bits;
using test::take_steps;

TEST(ThesisFormulation, GoesOnFromACheckpointToTheSameBitsOnAnyThreads)
{
    const config::Options options = printed_case();
    model::Model body = prepare::prepare_body(options).model;
    const int threads = thread_count();
    set_thread_count(2);
    model::Simulation whole(test::shared(body), options);
    take_steps(whole, 10);
    const record::Checkpoint checkpoint = record::to_checkpoint(whole.state(), {}, "case");
    take_steps(whole, 10);
    set_thread_count(1);
    model::Simulation resumed(test::shared(body), options);
    resumed.restore(record::from_checkpoint(checkpoint, body.cloud.positions.size(), "checkpoint.h5").state);
    take_steps(resumed, 10);
    set_thread_count(threads);
    expect_same_bits(whole, resumed);
    EXPECT_NEAR(whole.state().t, 20e-4, 1e-15); // steps are fixed
    EXPECT_GT(whole.state().energy_balance.dissipated, 0.0);
}

/// Near the surface eq. 10 takes the body at rest for compressed; eq. 9 pushes from where pressure is higher, which is
/// the surface, to where it is lower.
TEST(ThesisFormulation, AsPrintedTheBodyCollapsesBeforeItGrows)
{
    const config::Options options = printed_case({"tissue.alpha_t=0.0"});
    model::Model body = prepare::prepare_body(options).model;
    model::Simulation simulation(test::shared(body), options);
    EXPECT_LT(simulation.internal().smallest_J, 0.5);
    EXPECT_GT(simulation.internal().elastic_energy, 1000.0);
    const auto i = static_cast<std::size_t>(body.cloud.surface_particles[0]);
    try
    {
        take_steps(simulation, 1000);
        FAIL() << "it did not collapse";
    }
    catch (const RunError& error)
    {
        EXPECT_THAT(error.what(), testing::HasSubstr("inverted"));
    }
    EXPECT_LT(norm(simulation.state().motion.x[i]), 0.9 * norm(body.cloud.positions[i]));
}

TEST(ThesisFormulation, WithTheGradientCorrectedItRests)
{
    const config::Options options = printed_case({"tissue.alpha_t=0.0", "thesis.gradient=corrected"});
    model::Model body = prepare::prepare_body(options).model;
    model::Simulation simulation(test::shared(body), options);
    take_steps(simulation, 20);
    for (std::size_t i = 0; i < body.cloud.positions.size(); ++i)
    {
        ASSERT_LT(norm(simulation.state().motion.x[i] - body.cloud.positions[i]), 1e-9);
    }
}

} // namespace
} // namespace corticle
