// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/thread_ranks.hpp"
#include "corticle/base/error.hpp"
#include "corticle/model/scatter.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/model/terms.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace corticle
{
namespace
{

/// A simulation in which every kind of node has been moved a little, so that nothing is hidden by symmetry.
struct Trial
{
    std::string name;
    std::function<void(config::Options&)> change;
    std::int64_t particles = 2500;
    double amplitude = 0.05; ///< of what nodes are moved by, in spacings
    int steps = 5;
};

void PrintTo(const Trial& trial, std::ostream* stream)
{
    *stream << trial.name;
}

config::Options options_of(const Trial& trial)
{
    config::Options options = test::sphere_options(trial.particles);
    options.contact.enabled = false;
    trial.change(options);
    return options;
}

/// The simulation after some steps, as one of the ranks makes them.
std::unique_ptr<model::Simulation> simulated(const std::shared_ptr<const model::Model>& body, const Trial& trial,
                                             const Communicator& ranks, int steps)
{
    const config::Options options = options_of(trial);
    model::Model part = ranks.is_root() ? *body : model::Model();
    const Share share = model::scatter(part, options, ranks);
    auto simulation = std::make_unique<model::Simulation>(test::shared(part), options, share);
    model::State start = ranks.is_root() ? test::rough_start(*body, trial.amplitude) : model::State();
    model::broadcast(start, ranks);
    simulation->restore(start);
    test::take_steps(*simulation, steps);
    simulation->complete();
    return simulation;
}

/// What is stored at the end, by kind.
std::vector<double> energies_of(const model::Simulation& simulation)
{
    std::vector<double> values;
    for (const mechanics::NamedEnergy& energy : simulation.energies())
    {
        values.push_back(energy.value);
    }
    return values;
}

bool is_same(const Mat3& a, const Mat3& b)
{
    return std::ranges::equal(a.column, b.column);
}

class Ranks : public testing::TestWithParam<Trial>
{
};

TEST_P(Ranks, GiveTheBitsOfOne)
{
    const Trial& trial = GetParam();
    const int steps = trial.steps;
    const auto body = test::shared(prepare::prepare_body(options_of(trial)).model);
    const auto one = simulated(body, trial, alone(), steps);
    const std::vector<Mat3> F = one->deformation_gradients();
    const int most = trial.particles > 8000 ? 8 : 3;
    for (const auto [ranks, threads] : {std::array{2, 2}, std::array{most, 1}})
    {
        SCOPED_TRACE(testing::Message() << ranks << " ranks, " << threads << " threads");
        test::with_ranks(ranks, threads,
                         [&](const Communicator& rank)
                         {
                             const auto part = simulated(body, trial, rank, steps);
                             const std::vector<Mat3> F_of_ranks = part->deformation_gradients();
                             if (rank.is_root())
                             {
                                 test::expect_same_bits(*one, *part);
                                 EXPECT_EQ(energies_of(*one), energies_of(*part));
                                 EXPECT_EQ(one->contact().largest_rate, part->contact().largest_rate);
                                 EXPECT_EQ(one->state().history, part->state().history);
                                 EXPECT_EQ(one->internal().smallest_J_at, part->internal().smallest_J_at);
                                 EXPECT_TRUE(std::ranges::equal(F, F_of_ranks, is_same));
                             }
                         });
    }
}

const Trial trials[] = {
    {"tissue", [](config::Options&) {}, 9000},
    {"contact",
     [](config::Options& options)
     {
         options.contact.enabled = true;
         options.contact.distance = 0.6;
     },
     2500, 0.2},
    {"contact_of_many",
     [](config::Options& options)
     {
         options.contact.enabled = true;
         options.contact.distance = 0.6;
     },
     9000, 0.3, 40}, // candidates are found anew on the way
    {"contact_at_supports",
     [](config::Options& options)
     {
         options.contact.enabled = true;
         options.contact.distance = 0.6;
         boundary::SupportOptions fixed;
         fixed.plane = boundary::Face::x_min;
         options.supports = {fixed};
     },
     2500, 0.2},
    {"thinning", [](config::Options& options) { options.tissue.thickness_rate_mm = 0.4; }},
    {"sharp_thinning",
     [](config::Options& options)
     {
         options.tissue.thickness_rate_mm = 0.4;
         options.tissue.layer = material::Layer::binary;
     }},
    {"runge_kutta", [](config::Options& options) { options.dynamics.integrator = dynamics::Integrator::rk4; }},
    {"remodelling",
     [](config::Options& options)
     {
         material::RemodellingOptions& remodelling = options.tissue.remodelling;
         remodelling.fibres.direction = material::FibreField::radial;
         remodelling.fibres.stiffness = 0.5;
         remodelling.fibres.active_stress = 0.05;
         remodelling.fibres.growth_rate = 5.0;
         remodelling.relaxation = {0.5, 0.05};
         remodelling.stress_growth.rate = 3.0;
     }},
    {"skull",
     [](config::Options& options)
     {
         options.contact.enabled = true;
         options.boundary.shape = boundary::SkullShape::offset;
         options.boundary.offset_mm = 0.5;
         options.boundary.kind = boundary::SkullKind::elastic;
         options.boundary.fluid = boundary::Fluid::conserved;
         options.boundary.bulk_modulus = 0.1;
         options.dynamics.cfl = 0.15;
     }},
    {"supports",
     [](config::Options& options)
     {
         boundary::SupportOptions roller;
         roller.kind = boundary::SupportKind::roller;
         roller.plane = boundary::Face::x_min;
         boundary::SupportOptions moved;
         moved.kind = boundary::SupportKind::displacement;
         moved.high_mm = {100.0, 100.0, 100.0};
         moved.low_mm = {10.0, -100.0, -100.0};
         moved.axes = boundary::Axes::x;
         moved.displacement_mm = {0.1, 0.0, 0.0};
         options.supports = {roller, moved};
     }},
    {"tracts",
     [](config::Options& options)
     {
         const auto file = std::filesystem::path(testing::TempDir()) / "corticle_tracts_of_ranks.csv";
         std::ofstream(file) << "from_x,from_y,from_z,to_x,to_y,to_z\n-6,0,2,7,1,0\n0,8,0,-6,0,2\n";
         options.tracts.file = file.string();
         options.tracts.stiffness = 5.0;
         options.tracts.rest = 0.7;
         options.tracts.rate = 3.0;
     }},
    {"thesis", [](config::Options& options) { options.formulation = thesis::Formulation::thesis; }, 1500, 0.01},
    {"tets", [](config::Options& options) { options.method = model::Method::fem; }, 1500, 0.01},
};

INSTANTIATE_TEST_SUITE_P(All, Ranks, testing::ValuesIn(trials), [](const auto& trial) { return trial.param.name; });

TEST(RanksThatFail, SayTheSameWhoeverOwnsTheParticle)
{
    const Trial trial = trials[0];
    const auto body = test::shared(prepare::prepare_body(options_of(trial)).model);
    const auto fail = [&](const Communicator& ranks)
    {
        model::State state = test::rough_start(*body, 0.05);
        state.motion.x[8000] = -1.0 * state.motion.x[8000];
        const config::Options options = options_of(trial);
        model::Simulation simulation(body, options, model::make_share(*body, options, ranks));
        simulation.restore(state);
    };
    std::string expected;
    try
    {
        fail(alone());
    }
    catch (const RunError& error)
    {
        expected = error.what();
    }
    EXPECT_THAT(expected, testing::HasSubstr("inverted"));
    try
    {
        test::with_ranks(3, 1, fail);
        FAIL();
    }
    catch (const RunError& error)
    {
        EXPECT_EQ(error.what(), expected);
    }
}

TEST(RanksThatFail, TakeNoForcesFromOutside)
{
    const Trial trial{"tissue", [](config::Options&) {}};
    const auto body = test::shared(prepare::prepare_body(options_of(trial)).model);
    const auto add = [&](const Communicator& ranks)
    {
        const config::Options options = options_of(trial);
        model::Simulation simulation(body, options, model::make_share(*body, options, ranks));
        simulation.add_term(nullptr);
    };
    EXPECT_THROW(test::with_ranks(2, 1, add), InputError);
}

} // namespace
} // namespace corticle
