// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tracts/tract_term.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/prepare/tract_file.hpp"
#include "corticle/record/checkpointing.hpp"
#include "mechanics/energy_gradient.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace corticle
{
namespace
{

using tracts::Tracts;
using tracts::TractTerm;

/// Three ends of one, four and a hundred nodes, of which the last two share some; a tract between each two.
Tracts three_tracts(const model::Model& model, double rest, double rate)
{
    const auto end = [&](std::int32_t first, std::int32_t count)
    {
        tracts::TractEnd made;
        double mass = 0.0;
        for (std::int32_t i = first; i < first + count; ++i)
        {
            made.nodes.push_back(i);
            made.shares.push_back(model.cloud.volumes[i]);
            mass += model.cloud.volumes[i];
        }
        std::ranges::for_each(made.shares, [mass](double& share) { share /= mass; });
        return made;
    };
    Tracts result;
    result.ends = {end(5, 1), end(1200, 4), end(1202, 100)};
    result.tracts = {{0, 1, 2.0, rest, rate}, {1, 2, 0.7, rest, rate}, {2, 0, 1.3, rest, rate}};
    return result;
}

mechanics::Contribution evaluate(TractTerm& term, std::span<const Vec3> x, std::vector<Vec3>& forces,
                                 const mechanics::History& history = {}, double t_before = 0.0, double t = 0.2)
{
    const std::vector<Vec3> v(x.size());
    forces.assign(x.size(), {});
    return term.add({t, t_before, 1.0, 0.6, x, v, history}, forces);
}

TractTerm term_of(const Tracts& made)
{
    const model::Model& model = *test::small_model();
    return {made, model.cloud.positions, model.cloud.volumes, {}};
}

TEST(Tracts, ForcesAreMinusTheGradientOfTheirEnergyAndKeepMomenta)
{
    const model::Model& model = *test::small_model();
    const std::vector<Vec3> x = test::perturbed(model.cloud.positions, 0.2);
    for (const double rest : {0.6, 1.4})
    {
        Tracts made = three_tracts(model, rest, 0.0);
        made.push = true;
        TractTerm term = term_of(made);
        std::vector<Vec3> forces;
        evaluate(term, x, forces);
        EXPECT_GT(test::largest_norm(forces), 0.1);
        EXPECT_EQ(term.states()[0].tension > 0.0, rest < 1.0);
        test::expect_energy_gradient(
            x, forces,
            [&](std::span<const Vec3> at)
            {
                std::vector<Vec3> unused;
                evaluate(term, at, unused);
                return term.energies().front().value;
            },
            1e-4, 1e-7);
    }
}

TEST(Tracts, SlackOnesCarryNothingUnlessTheyPush)
{
    const model::Model& model = *test::small_model();
    TractTerm slack = term_of(three_tracts(model, 1.4, 0.0));
    std::vector<Vec3> forces;
    evaluate(slack, model.cloud.positions, forces);
    EXPECT_EQ(test::largest_norm(forces), 0.0);
    EXPECT_EQ(slack.energies().front().value, 0.0);
    EXPECT_EQ(slack.states()[1].tension, 0.0);
}

TEST(Tracts, AStretchedOneGrowsAsItsLawSays)
{
    const model::Model& model = *test::small_model();
    const double rate = 3.0;
    Tracts made = three_tracts(model, 0.8, rate);
    made.ramp_time = 1e-9; // at once, in the first step
    TractTerm term = term_of(made);
    std::vector<Vec3> forces;
    mechanics::History history;
    const std::vector<Vec3>& x = model.cloud.positions; // held: then L_0 = L - (L - 0.8 L) exp(-rate t)
    double work = 0.0;
    double power = 0.0;
    double first = 0.0;
    for (int step = 0; step <= 50; ++step)
    {
        const double t_before = step == 0 ? 0.0 : 0.001 + 0.01 * (step - 1);
        const double t = 0.001 + 0.01 * step;
        const mechanics::Contribution now = evaluate(term, x, forces, history, t_before, t);
        work += step > 0 ? 0.005 * (power + now.growth_power) : 0.0;
        power = now.growth_power;
        first = step == 0 ? term.energies().front().value : first;
        term.accept({t, t_before, 1.0, 0.6, x, x, history}, history);
    }
    for (const tracts::TractState& state : term.states())
    {
        EXPECT_NEAR(state.rest_length, state.length * (1.0 - 0.2 * std::exp(-rate * 0.5)), 1e-12 * state.length);
    }
    EXPECT_NEAR(term.energies().front().value - first, work, 0.002 * first);
    EXPECT_LT(work, -0.9 * first);
}

TEST(Tracts, TheyAreDrawnFromTheirLengthAtTheStart)
{
    const model::Model& model = *test::small_model();
    TractTerm term = term_of(three_tracts(model, 0.8, 0.0));
    std::vector<Vec3> forces;
    EXPECT_EQ(evaluate(term, model.cloud.positions, forces, {}, 0.0, 0.0).growth_power, 0.0);
    EXPECT_EQ(term.energies().front().value, 0.0);
    evaluate(term, model.cloud.positions, forces, {}, 0.0, 0.025);
    EXPECT_NEAR(term.states()[1].rest_length / term.states()[1].length, 0.9, 1e-12);
    evaluate(term, model.cloud.positions, forces, {}, 0.0, 0.5);
    EXPECT_NEAR(term.states()[1].rest_length / term.states()[1].length, 0.8, 1e-12);
}

TEST(Tracts, DeformABodyWithBalancedEnergyAndTheSameBitsOnResumption)
{
    Tracts made = three_tracts(*test::small_model(), 0.7, 0.5);
    made.ends = {made.ends[2], made.ends[2]}; // two places in the tissue, a hundred nodes each
    for (std::int32_t& node : made.ends[0].nodes)
    {
        node -= 900;
    }
    made.tracts = {{0, 1, 20.0, 0.7, 0.5}};
    auto model = std::make_shared<model::Model>(*test::small_model());
    model->tracts = made;
    config::Options options = test::sphere_options(2500);
    options.tissue.alpha_t = 0.2;
    const auto run = [](model::Simulation& simulation, double end)
    {
        while (simulation.state().t < end)
        {
            simulation.step(end);
        }
    };
    model::Simulation simulation(model, options);
    const auto& term = dynamic_cast<const TractTerm&>(
        **std::ranges::find_if(simulation.terms(), [](const auto& one) { return one->name() == "tracts"; }));
    const double length = term.states()[0].length;
    run(simulation, 0.2);
    EXPECT_LT(term.states()[0].length, 0.97 * length);
    EXPECT_GT(term.states()[0].tension, 0.0);
    const model::State& state = simulation.state();
    double stored = state.kinetic_energy + state.energy_balance.dissipated;
    for (const auto& [name, value] : simulation.energies())
    {
        stored += value;
    }
    EXPECT_NEAR(stored / state.energy_balance.growth_work, 1.0, 0.01);

    const int threads = thread_count();
    set_thread_count(threads == 1 ? 2 : 1);
    model::Simulation first(model, options);
    run(first, 0.1);
    const record::Checkpoint checkpoint = record::to_checkpoint(first.state(), {}, "case");
    model::Simulation second(model, options);
    second.restore(record::from_checkpoint(checkpoint, model->cloud.positions.size(), "checkpoint.h5").state);
    run(second, 0.2);
    set_thread_count(threads);
    model::Simulation whole(model, options);
    run(whole, 0.1); // its steps end there, too
    run(whole, 0.2);
    test::expect_same_bits(whole, second);
}

/// A table in a file, read for the small body, whose halves are regions 1 and 2.
Tracts read(const std::string& text, double radius = 0.0)
{
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "corticle_tracts.csv";
    std::ofstream(file) << text;
    model::Model model = *test::small_model();
    for (const Vec3& X : model.cloud.positions)
    {
        model.tissue.region.push_back(X.x < 0.0 ? 1.0 : 2.0);
    }
    tracts::TractOptions options;
    options.file = file.string();
    options.stiffness = 4.0;
    options.radius_mm = radius;
    return prepare::read_tracts(options, model);
}

TEST(TractFile, NamesRegionsOrPlaces)
{
    const Tracts regions = read("from,to,rest\n1,2,0.9\n2,1,0.8\n");
    ASSERT_EQ(regions.tracts.size(), 2u);
    ASSERT_EQ(regions.ends.size(), 2u); // each region once
    EXPECT_EQ(regions.tracts[1].from, regions.tracts[0].to);
    EXPECT_EQ(regions.tracts[0].rest, 0.9);
    EXPECT_EQ(regions.tracts[0].stiffness, 4.0);
    EXPECT_EQ(regions.ends[0].nodes.size() + regions.ends[1].nodes.size(), test::small_model()->cloud.positions.size());
    double shares = 0.0;
    std::ranges::for_each(regions.ends[0].shares, [&](double share) { shares += share; });
    EXPECT_NEAR(shares, 1.0, 1e-12);

    const Tracts places = read("from_x;from_y;from_z;to_x;to_y;to_z;stiffness\n-5;0;0;5;0;0;7\n", 3.0);
    for (const std::int32_t node : places.ends[1].nodes)
    {
        EXPECT_LE(norm(test::small_model()->cloud.positions[node] - Vec3{5.0, 0.0, 0.0}), 3.0);
    }
    EXPECT_GT(places.ends[1].nodes.size(), 10u);
    EXPECT_EQ(places.tracts[0].stiffness, 7.0);
}

TEST(TractFile, RefusesWhatIsNone)
{
    for (const auto& [text, part] :
         {std::pair("from,to\n", "no rows"), std::pair("a,b\n1,2\n", "no ends"), std::pair("from,to\n1,7\n", "label 7"),
          std::pair("from,to\n1,1\n", "no length"), std::pair("from,to\n1,x\n", "bad to"),
          std::pair("from,to,rest\n1,2,-1\n", "bad rest"), std::pair("from,to,colour\n1,2,3\n", "colour"),
          std::pair("from,to,to\n1,2,2\n", "to"),
          std::pair("from_x,from_y,from_z,to_x,to_y,to_z\n0,0,0,90,0,0\n", "(90, 0, 0) mm")})
    {
        try
        {
            read(text);
            ADD_FAILURE() << "accepted: " << text;
        }
        catch (const InputError& error)
        {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

} // namespace
} // namespace corticle
