// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/model/simulation.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

config::Options remodelled_options(model::Method method = model::Method::tlsph)
{
    config::Options options = test::sphere_options(2500);
    options.method = method;
    options.contact.enabled = false;
    options.dynamics.cfl = 0.1;
    options.dynamics.loading_time = 100.0;
    material::RemodellingOptions& remodelling = options.tissue.remodelling;
    remodelling.fibres.direction = material::FibreField::radial;
    remodelling.fibres.stiffness = 0.5;
    remodelling.fibres.active_stress = 0.05;
    remodelling.fibres.ramp = 0.05;
    remodelling.fibres.growth_rate = 5.0;
    remodelling.relaxation = {0.5, 0.05};
    remodelling.stress_growth.rate = 3.0;
    return options;
}

double energy_of(const model::Simulation& simulation, std::string_view name)
{
    for (const auto& energy : simulation.energies())
    {
        if (energy.name == name)
        {
            return energy.value;
        }
    }
    return 0.0;
}

class RemodelledSphere : public testing::TestWithParam<model::Method>
{
};

TEST_P(RemodelledSphere, EnergiesBalance)
{
    const config::Options options = remodelled_options(GetParam());
    model::Simulation simulation(test::shared(prepare::prepare_body(options).model), options);
    while (simulation.state().t < 0.1)
    {
        simulation.step(0.1);
    }
    const model::State& state = simulation.state();
    const double stored = simulation.internal().elastic_energy + simulation.internal().zero_mode_energy;
    const double released = energy_of(simulation, "remodelling");
    EXPECT_GT(released, 0.05 * state.energy_balance.growth_work);
    // Of first order in the step, as without a history.
    EXPECT_NEAR((stored + released + state.kinetic_energy + state.energy_balance.dissipated) /
                    state.energy_balance.growth_work,
                1.0, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Methods, RemodelledSphere, testing::Values(model::Method::tlsph, model::Method::fem),
                         [](const auto& method) { return method.param == model::Method::fem ? "fem" : "tlsph"; });

TEST(RemodelledSphere, IsTheSameForAnyThreadsAndFromAStateOnTheWay)
{
    const config::Options options = remodelled_options();
    const auto body = test::shared(prepare::prepare_body(options).model);
    model::Simulation whole(body, options);
    test::take_steps(whole, 12);
    const int threads = thread_count();
    set_thread_count(1);
    model::Simulation first(body, options);
    test::take_steps(first, 5);
    set_thread_count(threads);
    model::Simulation second(body, options);
    test::take_steps(second, 3); // what it carries is to be forgotten
    second.restore(first.state());
    test::take_steps(second, 7);
    test::expect_same_bits(whole, second);
    EXPECT_EQ(whole.state().history, second.state().history);
    EXPECT_EQ(whole.state().history.at("relaxation.strain").size(), 6 * body->cloud.positions.size());
}

TEST(RemodelledSphere, RefusesTheHistoryOfAnotherBody)
{
    const config::Options options = remodelled_options();
    model::Simulation simulation(test::shared(prepare::prepare_body(options).model), options);
    model::State state = simulation.state();
    state.history["relaxation.strain"] = {1.0};
    EXPECT_THROW(simulation.restore(state), InputError);
}

} // namespace
} // namespace corticle
