// SPDX-License-Identifier: GPL-3.0-or-later
// How an observer is added: this file is all that one needs to follow a run.
#include "corticle/base/error.hpp"
#include "corticle/model/observer.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Notes the area of the surface at output times, and asks for the end where it has grown enough.
class AreaWatch final : public model::Observer
{
  public:
    explicit AreaWatch(double enough) : enough_(enough) {}

    void on_step(const model::Simulation& /*simulation*/) override { ++steps; }
    void on_output(const model::OutputView& view) override
    {
        numbers.push_back(view.number);
        areas.push_back(surface_area(view.surface, view.triangles()));
    }
    void on_end(const model::Simulation& /*simulation*/, model::RunStatus status) override { ended = status; }
    bool has_enough() const { return areas.back() > enough_ * areas.front(); }

    std::int64_t steps = 0;
    std::vector<std::size_t> numbers;
    std::vector<double> areas;
    model::RunStatus ended{};

  private:
    double enough_;
};

TEST(ObserverExample, SeesEveryOutputAndMayEndTheRun)
{
    model::Simulation simulation(test::small_model(), test::sphere_options(2500));
    AreaWatch watch(1.02);
    model::Observer* const observers[]{&watch};
    const std::vector<double> times{0.0, 0.02, 0.04, 0.06, 1.0};
    const model::RunStatus status = model::fold(simulation, times, 3, observers, [&] { return watch.has_enough(); });
    EXPECT_EQ(status, model::RunStatus::interrupted);
    EXPECT_EQ(watch.ended, model::RunStatus::interrupted);
    EXPECT_THAT(watch.numbers, testing::ElementsAre(3, 4, 5));
    EXPECT_GT(watch.steps, 10);
    EXPECT_LT(simulation.state().t, 0.06);
}

TEST(ObserverExample, TwoSimulationsShareAModel)
{
    config::Options options = test::sphere_options(2500);
    model::Simulation one(test::small_model(), options);
    options.tissue.alpha_t = 0.5;
    model::Simulation other(test::small_model(), options);
    model::Simulation alone(test::small_model(), options);
    for (int k = 0; k < 20; ++k)
    {
        one.step(1.0);
        other.step(1.0);
        alone.step(1.0);
    }
    EXPECT_EQ(other.state().motion.x, alone.state().motion.x);
    EXPECT_NE(other.state().motion.x, one.state().motion.x);
}

TEST(SimulationEntry, RefusesAStateOfAnotherSize)
{
    model::Simulation simulation(test::small_model(), test::sphere_options(2500));
    model::State state;
    state.motion.x.resize(7);
    EXPECT_THROW(simulation.restore(state), InputError);
}

} // namespace
} // namespace corticle
