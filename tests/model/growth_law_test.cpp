// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/growth_law.hpp"

#include "corticle/base/error.hpp"
#include "corticle/model/node_stress.hpp"
#include "corticle/model/simulation.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace corticle
{
namespace
{

using material::TissueGrowthAt;
using test::expect_same_bits;
using test::take_steps;
using testing::HasSubstr;

using Ask = std::function<void(const model::Simulation&, double, std::span<TissueGrowthAt>)>;

class Law final : public model::GrowthLaw
{
  public:
    explicit Law(Ask ask) : ask_(std::move(ask)) {}
    void ask(const model::Simulation& present, double t, std::span<TissueGrowthAt> growth) override
    {
        ask_(present, t, growth);
    }

  private:
    Ask ask_;
};

std::unique_ptr<Law> law(Ask ask)
{
    return std::make_unique<Law>(std::move(ask));
}

/// Calls every third step it is asked for invalid: the step is taken back.
class Refusing final : public mechanics::ForceTerm
{
  public:
    std::string_view name() const override { return "refusing"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> /*forces*/) override
    {
        return {.invalid_at = context.dt > 0.0 && ++asked_ % 3 == 0 ? 0 : -1};
    }

  private:
    int asked_ = 0;
};

/// The law of the keys: g_t = 1 + alpha theta t.
Ask keys(double alpha)
{
    return [alpha](const model::Simulation& present, double t, std::span<TissueGrowthAt> growth)
    {
        for (std::size_t i = 0; i < growth.size(); ++i)
        {
            growth[i].tangential = 1.0 + alpha * present.state().nodes.theta[i] * t;
            growth[i].radial = 1.0;
        }
    };
}

/// Growth of what is there, the faster the less it is pressed together.
void by_pressure(const model::Simulation& present, double t, std::span<TissueGrowthAt> growth)
{
    const model::NodeStress stresses(present);
    const std::vector<Mat3> F = present.deformation_gradients();
    for (std::size_t i = 0; i < growth.size(); ++i)
    {
        const double rate = (2.0 + trace(stresses.cauchy(i, F[i]))) * present.state().nodes.theta[i];
        growth[i].tangential *= 1.0 + rate * (t - present.state().t);
        growth[i].radial *= 1.0 + 0.2 * rate * (t - present.state().t);
    }
}

/// Everything that a law may look at moves or has a history.
config::Options moving_options(model::Method method)
{
    config::Options options = test::sphere_options(1500);
    options.method = method;
    options.tissue.thickness_rate_mm = 2.0;
    options.tissue.remodelling.relaxation = {0.5, 0.05};
    return options;
}

class GrowthLaws : public testing::TestWithParam<model::Method>
{
  protected:
    config::Options options = moving_options(GetParam());
    std::shared_ptr<const model::Model> model = test::shared(prepare::prepare_body(options).model);
};

/// Takes steps with both; they do the same but for round-off.
void expect_same_fold(model::Simulation& by_keys, model::Simulation& by_law)
{
    take_steps(by_keys, 40);
    take_steps(by_law, 40);
    const model::State& expected = by_keys.state();
    const model::State& state = by_law.state();
    EXPECT_NEAR(state.t, expected.t, 1e-9 * expected.t);
    EXPECT_NEAR(state.energy_balance.growth_work, expected.energy_balance.growth_work,
                1e-6 * expected.energy_balance.growth_work);
    const std::vector<Vec3>& X = by_keys.model().cloud.positions;
    double moved = 0.0;
    double apart = 0.0;
    for (std::size_t i = 0; i < X.size(); ++i)
    {
        moved = std::max(moved, norm(expected.motion.x[i] - X[i]));
        apart = std::max(apart, norm(expected.motion.x[i] - state.motion.x[i]));
    }
    EXPECT_GT(moved, 0.05);
    EXPECT_LT(apart, 1e-8 * moved);
}

TEST_P(GrowthLaws, UniformGrowthIsThatOfTheKeys)
{
    options.tissue.alpha_t = options.tissue.alpha_r = options.tissue.alpha_white = 0.5;
    model::Simulation by_keys(model, options);
    model::Simulation by_law(model, options);
    by_law.set_growth_law(law(
        [](const model::Simulation&, double t, std::span<TissueGrowthAt> growth) {
            std::ranges::fill(growth, TissueGrowthAt{1.0 + 0.5 * t, 1.0 + 0.5 * t});
        }));
    expect_same_fold(by_keys, by_law);
}

TEST(GrowthLaws, TheLawOfTheKeysFoldsAsTheKeysDo)
{
    const config::Options options = test::sphere_options(2500);
    model::Simulation by_keys(test::small_model(), options);
    model::Simulation by_law(test::small_model(), options);
    by_law.set_growth_law(law(keys(options.tissue.alpha_t)));
    expect_same_fold(by_keys, by_law);
}

TEST_P(GrowthLaws, GoOnFromACheckpointToTheSameBits)
{
    model::Simulation whole(model, options);
    whole.set_growth_law(law(by_pressure));
    take_steps(whole, 15);
    const model::State state = whole.state();
    take_steps(whole, 15);
    model::Simulation resumed(model, options);
    resumed.set_growth_law(law(by_pressure));
    resumed.restore(state);
    take_steps(resumed, 15);
    expect_same_bits(whole, resumed);
    EXPECT_NE(whole.tissue().point(0, whole.state().t).growth_rate, 0.0);
    EXPECT_EQ(whole.tissue().point(0, whole.state().t).growth, resumed.tissue().point(0, resumed.state().t).growth);
}

/// A step that is taken back must not show in what the law sees when it is asked again.
TEST_P(GrowthLaws, SeeThePresentStateHoweverOftenTheyAreAsked)
{
    struct Seen
    {
        std::int64_t step;
        std::vector<double> numbers;
    };
    std::vector<Seen> seen;
    model::Simulation simulation(model, options);
    simulation.set_growth_law(law(
        [&](const model::Simulation& present, double t, std::span<TissueGrowthAt> growth)
        {
            by_pressure(present, t, growth);
            const model::NodeStress stresses(present);
            const std::vector<Mat3> F = present.deformation_gradients();
            Seen now{present.state().steps, {}};
            for (std::size_t i = 0; i < F.size(); ++i)
            {
                const material::MaterialPoint point = present.tissue().point(i, present.state().t);
                now.numbers.insert(now.numbers.end(),
                                   {stresses.cauchy(i, F[i])(0, 0), point.growth, point.shear_modulus});
            }
            seen.push_back(std::move(now));
        }));
    simulation.add_term(std::make_unique<Refusing>());
    take_steps(simulation, 20);
    ASSERT_GT(simulation.state().rejected_steps, 5);
    int again = 0;
    for (std::size_t k = 1; k < seen.size(); ++k)
    {
        if (seen[k].step == seen[k - 1].step)
        {
            EXPECT_EQ(seen[k].numbers, seen[k - 1].numbers) << "step " << seen[k].step;
            ++again;
        }
    }
    EXPECT_GT(again, 5);
}

TEST_P(GrowthLaws, ARefusedLawLeavesTheSimulationAsItWas)
{
    model::Simulation simulation(model, options);
    model::Simulation plain(model, options);
    const auto refuses = [&](const Ask& ask, const char* message)
    {
        try
        {
            simulation.set_growth_law(law(ask));
            ADD_FAILURE() << "expected: " << message;
        }
        catch (const InputError& error)
        {
            EXPECT_THAT(error.what(), HasSubstr(message));
        }
    };
    refuses([](auto&, double, auto growth) { growth[7].tangential = 1.1; }, "at particle 7 at the start");
    refuses([](auto&, double t, auto growth) { growth[3].radial = t > 0.0 ? -1.0 : 1.0; },
            "at particle 3, expected finite");
    refuses([](auto&, double, auto growth) { growth[2].tangential = std::nan(""); }, "at particle 2");
    take_steps(simulation, 5);
    take_steps(plain, 5);
    expect_same_bits(simulation, plain);
    EXPECT_THROW(simulation.set_growth_law(law(by_pressure)), InputError); // after steps
    EXPECT_TRUE(simulation.state().history == plain.state().history);
}

TEST_P(GrowthLaws, StatesWithAndWithoutALawAreToldApart)
{
    model::Simulation with(model, options);
    model::Simulation without(model, options);
    with.set_growth_law(law(by_pressure));
    EXPECT_THROW(with.set_growth_law(law(by_pressure)), InputError);
    take_steps(with, 2);
    take_steps(without, 2);
    EXPECT_THROW(with.restore(model::State(without.state())), InputError);
    EXPECT_THROW(without.restore(model::State(with.state())), InputError);
}

INSTANTIATE_TEST_SUITE_P(Methods, GrowthLaws, testing::Values(model::Method::tlsph, model::Method::fem),
                         [](const auto& method)
                         { return std::string(method.param == model::Method::fem ? "fem" : "tlsph"); });

} // namespace
} // namespace corticle
