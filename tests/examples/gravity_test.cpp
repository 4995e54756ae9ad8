// SPDX-License-Identifier: GPL-3.0-or-later
// How a force term is added: this file is all that a uniform gravity needs.
#include "corticle/mechanics/force_term.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Weight of the nodes, m g, with the potential -sum m g . x.
class Gravity final : public mechanics::ForceTerm
{
  public:
    /// @param acceleration  g [mm per unit of time squared]
    Gravity(std::span<const double> masses, const Vec3& acceleration)
        : masses_(masses.begin(), masses.end()), acceleration_(acceleration)
    {
    }

    std::string_view name() const override { return "gravity"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override
    {
        potential_ = 0.0;
        for (std::size_t i = 0; i < masses_.size(); ++i)
        {
            forces[i] += masses_[i] * acceleration_;
            potential_ -= masses_[i] * dot(acceleration_, context.x[i]);
        }
        return {};
    }
    std::vector<mechanics::NamedEnergy> energies() const override { return {{"gravity", potential_}}; }
    void accept(const mechanics::StepContext& context, mechanics::History& history) override
    {
        std::vector<double>& fallen = history["gravity.falling_time"];
        fallen.resize(1);
        fallen[0] += context.dt;
    }

  private:
    std::vector<double> masses_;
    Vec3 acceleration_;
    double potential_ = 0.0;
};

Vec3 centre_of_mass(const model::Simulation& simulation)
{
    const std::vector<double>& masses = simulation.model().cloud.volumes;
    Vec3 sum;
    double mass = 0.0;
    for (std::size_t i = 0; i < masses.size(); ++i)
    {
        sum += masses[i] * simulation.state().motion.x[i];
        mass += masses[i];
    }
    return sum / mass;
}

TEST(ForceTermExample, GravityLetsABodyFallAsNewtonSays)
{
    config::Options options = test::sphere_options(2500);
    options.dynamics.damping = 0.0;
    options.tissue.alpha_t = 0.0;
    model::Simulation simulation(test::small_model(), options);
    const Vec3 g{0.0, 0.0, -0.5};
    simulation.add_term(std::make_unique<Gravity>(simulation.model().cloud.volumes, g));
    EXPECT_EQ(simulation.terms().back()->name(), "gravity");
    const Vec3 start = centre_of_mass(simulation);
    for (int k = 0; k < 50; ++k)
    {
        simulation.step(1.0);
    }
    const double time = simulation.state().t * simulation.total_time();
    const double fallen = dot(centre_of_mass(simulation) - start, g) / squared_norm(g);
    // Symplectic Euler falls sum_k k dt² = t²/2 (1 + 1/steps).
    EXPECT_NEAR(fallen / (0.5 * time * time * (1.0 + 1.0 / 50.0)), 1.0, 1e-6);
    EXPECT_NEAR(simulation.state().history.at("gravity.falling_time")[0] / time, 1.0, 1e-12);
}

} // namespace
} // namespace corticle
