// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/mooney_rivlin.hpp"
#include "mechanics/energy_gradient.hpp"
#include "mechanics/methods.hpp"

#include <gtest/gtest.h>

// A material of which the program knows nothing, added by its file and, for each method, the line that hands it to the
// solver.

namespace corticle
{
namespace
{

constexpr double growth_time = 0.3;
constexpr test::MooneyRivlin other_law{0.4, 0.3};

template <class Body>
class OtherMaterial : public testing::Test
{
  protected:
    double energy_at(std::span<const Vec3> positions)
    {
        std::vector<Vec3> forces(positions.size());
        const mechanics::InternalResponse response = solver->evaluate(positions, growth_time, forces);
        EXPECT_EQ(response.invalid_at, -1);
        return response.elastic_energy + response.zero_mode_energy;
    }

    /// Forces against the energy, along some random directions of all nodes together.
    void expect_gradient(std::span<const Vec3> at, double tolerance)
    {
        std::vector<Vec3> forces(at.size());
        ASSERT_EQ(solver->evaluate(at, growth_time, forces).invalid_at, -1);
        test::expect_energy_gradient(
            at, forces, [this](std::span<const Vec3> positions) { return energy_at(positions); }, 1e-5 * body.spacing(),
            tolerance);
    }

    Body body;
    std::unique_ptr<mechanics::Discretization> solver = body.solver(other_law);
    std::vector<Vec3> x = test::perturbed(body.X(), 0.1 * body.spacing());
};

using Methods = testing::Types<test::OfParticles, test::OfTets>;
TYPED_TEST_SUITE(OtherMaterial, Methods);

TYPED_TEST(OtherMaterial, ForcesAreTheNegativeGradientOfTheEnergy)
{
    // Round-off of an energy of some thousand over h, and h² times its third derivative.
    this->expect_gradient(this->x, 1e-7);
}

TYPED_TEST(OtherMaterial, IsNotTheLawOfTheProgram)
{
    std::vector<Vec3> forces(this->x.size());
    const mechanics::InternalResponse known = this->body.solver()->evaluate(this->x, growth_time, forces);
    const mechanics::InternalResponse other = this->solver->evaluate(this->x, growth_time, forces);
    EXPECT_GT(std::abs(other.elastic_energy / known.elastic_energy - 1.0), 1e-4);
    // The same formulas compiled beside another law: the compiler contracts them differently.
    EXPECT_NEAR(other.smallest_J / known.smallest_J, 1.0, 1e-12);
    EXPECT_NEAR(other.stiffest_rate / known.stiffest_rate, 1.0, 1e-12);
}

TYPED_TEST(OtherMaterial, MovesAndKeepsItsEnergy)
{
    std::vector<Vec3> at = this->x;
    const std::vector<double>& mass = this->body.mass();
    std::vector<Vec3> forces(at.size());
    std::vector<Vec3> v(at.size());
    mechanics::InternalResponse response = this->solver->evaluate(at, growth_time, forces);
    const double start = response.elastic_energy + response.zero_mode_energy;
    const double dt = 0.1 * this->body.spacing() / response.stiffest_rate;
    double kinetic = 0.0;
    for (int step = 0; step < 40; ++step)
    {
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            v[i] += (0.5 * dt / mass[i]) * forces[i];
            at[i] += dt * v[i];
        }
        response = this->solver->evaluate(at, growth_time, forces);
        ASSERT_EQ(response.invalid_at, -1);
        kinetic = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            v[i] += (0.5 * dt / mass[i]) * forces[i];
            kinetic += 0.5 * mass[i] * squared_norm(v[i]);
        }
    }
    EXPECT_GT(kinetic, 0.05 * start);
    // The velocity Verlet scheme errs by (omega dt)² / 8 of the energy, here at most a per cent.
    EXPECT_NEAR((kinetic + response.elastic_energy + response.zero_mode_energy) / start, 1.0, 0.01);
}

using OtherMaterialOfTets = OtherMaterial<test::OfTets>;

TEST_F(OtherMaterialOfTets, IsExtrapolatedWhereTetsAreInverted)
{
    x = test::perturbed(body.X(), 0.35);
    solver = body.solver(test::MooneyRivlin{0.4, 0.0});
    std::vector<Vec3> forces(x.size());
    EXPECT_GT(solver->evaluate(x, growth_time, forces).extrapolated_count, 0);
    expect_gradient(x, 1e-6);
}

} // namespace
} // namespace corticle
