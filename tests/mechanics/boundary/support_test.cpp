// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/support_term.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/record/checkpointing.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using boundary::Face;
using boundary::SupportKind;
using boundary::SupportOptions;
using testing::HasSubstr;

SupportOptions on_plane(SupportKind kind, Face face)
{
    SupportOptions support;
    support.kind = kind;
    support.plane = face;
    return support;
}

/// A bar of 12 x 5 x 5 mm that is drawn along x, free to contract.
config::Options drawn_bar(double displacement)
{
    config::Options options;
    options.geometry.shape = prepare::Shape::box;
    options.geometry.size_mm = {12.0, 5.0, 5.0};
    options.geometry.particles = 1200;
    options.tissue.alpha_t = 0.0;
    options.tissue.mu_cortex = 1.0;
    options.imperfection.amplitude = 0.0;
    options.supports = {on_plane(SupportKind::roller, Face::x_min), on_plane(SupportKind::roller, Face::y_min),
                        on_plane(SupportKind::roller, Face::z_min), on_plane(SupportKind::displacement, Face::x_max)};
    options.supports[3].displacement_mm = {displacement, 0.0, 0.0};
    options.supports[3].end = 0.5;
    return options;
}

std::shared_ptr<const model::Model> bar()
{
    static const auto model = std::make_shared<const model::Model>(prepare::prepare_body(drawn_bar(0.1)).model);
    return model;
}

const boundary::SupportTerm& supports_of(const model::Simulation& simulation)
{
    return dynamic_cast<const boundary::SupportTerm&>(*simulation.terms().back());
}

TEST(Supports, ABarIsDrawnByTheForceOfElasticity)
{
    constexpr double strain = 0.01;
    config::Options options = drawn_bar(12.0 * strain);
    options.dynamics.cfl = 0.25; // drag in long steps is of first order in them
    model::Simulation simulation(bar(), options);
    while (simulation.state().t < 0.8)
    {
        simulation.step(0.8);
    }
    const auto states = supports_of(simulation).states();
    const double K = 5.0;
    const double young = 9.0 * K / (3.0 * K + 1.0);
    // The law is not linear, and the faces of 5 mm have some 8 particles along an edge.
    EXPECT_NEAR(states[3].reaction.x / (young * strain * 25.0), 1.0, 0.04);
    EXPECT_NEAR(states[0].reaction.x / states[3].reaction.x, -1.0, 0.01);
    EXPECT_NEAR(states[1].reaction.y, 0.0, 0.01 * states[3].reaction.x);
    EXPECT_NEAR(states[3].displacement.x, 12.0 * strain, 1e-12);
    const model::State& state = simulation.state();
    double stored = state.kinetic_energy + state.energy_balance.dissipated;
    for (const auto& [name, value] : simulation.energies())
    {
        stored += value;
    }
    EXPECT_NEAR(stored / state.energy_balance.growth_work, 1.0, 0.01);
}

TEST(Supports, HeldDegreesStayWhereTheyAreToTheLastBit)
{
    config::Options options = drawn_bar(0.5);
    options.tissue.alpha_t = 1.0;
    const model::Model& body = *bar();
    model::Simulation simulation(bar(), options);
    test::take_steps(simulation, 40);
    for (const auto& [node, axis, support] : boundary::held_degrees(body.cloud, options.supports))
    {
        const double way = support == 3 ? simulation.state().t / 0.5 * 0.5 : 0.0;
        EXPECT_EQ(simulation.state().motion.x[node][axis], body.cloud.positions[node][axis] + way);
        EXPECT_EQ(simulation.state().motion.force[node][axis], 0.0);
    }
}

TEST(Supports, ThreadsAndResumptionsGiveTheSameBits)
{
    config::Options options = drawn_bar(0.5);
    options.tissue.alpha_t = 1.0;
    const int threads = thread_count();
    set_thread_count(1);
    model::Simulation one(bar(), options);
    test::take_steps(one, 40);
    set_thread_count(2);
    model::Simulation two(bar(), options);
    test::take_steps(two, 20);
    const record::Checkpoint checkpoint = record::to_checkpoint(two.state(), {}, "case");
    model::Simulation resumed(bar(), options);
    resumed.restore(record::from_checkpoint(checkpoint, bar()->cloud.positions.size(), "checkpoint.h5").state);
    test::take_steps(resumed, 20);
    set_thread_count(threads);
    test::expect_same_bits(one, resumed);
}

TEST(Supports, WhatComesLaterStandsBeforeThem)
{
    struct Idle final : mechanics::ForceTerm
    {
        std::string_view name() const override { return "idle"; }
        mechanics::Contribution add(const mechanics::StepContext&, std::span<Vec3>) override { return {}; }
    };
    model::Simulation simulation(bar(), drawn_bar(0.1));
    simulation.add_term(std::make_unique<Idle>());
    EXPECT_EQ(simulation.terms().back()->name(), "supports");
}

TEST(Supports, RefuseWhatCannotBe)
{
    const auto message_of = [](std::vector<SupportOptions> supports) -> std::string
    {
        try
        {
            boundary::held_degrees(bar()->cloud, supports);
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    };
    SupportOptions beside = on_plane(SupportKind::fixed, Face::none);
    beside.low_mm = {100.0, 0.0, 0.0};
    EXPECT_THAT(message_of({beside}), HasSubstr("support 1 holds no node"));
    SupportOptions moved = on_plane(SupportKind::displacement, Face::x_max);
    moved.displacement_mm = {1.0, 0.0, 0.0};
    EXPECT_THAT(message_of({on_plane(SupportKind::fixed, Face::x_max), moved}),
                HasSubstr("supports 1 and 2 both hold the node"));
    EXPECT_EQ(message_of({on_plane(SupportKind::fixed, Face::x_max), on_plane(SupportKind::roller, Face::y_max)}), "");
}

} // namespace
} // namespace corticle
