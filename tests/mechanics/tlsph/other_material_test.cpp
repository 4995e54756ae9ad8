// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/deformation_pass.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "material/mooney_rivlin.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "momenta.hpp"

#include <gtest/gtest.h>

// A material of which the program knows nothing, added by its file and the line that hands it to the solver.

namespace corticle
{
namespace
{

constexpr double growth_time = 0.3;

class OtherMaterial : public testing::Test
{
  protected:
    OtherMaterial() : solver(body.particles, body.tissue, tlsph::deformation_pass(test::MooneyRivlin{0.4, 0.3})) {}

    double energy_at(std::span<const Vec3> positions)
    {
        std::vector<Vec3> forces(positions.size());
        const mechanics::InternalResponse response = solver.evaluate(positions, growth_time, forces);
        EXPECT_EQ(response.invalid_at, -1);
        return response.elastic_energy + response.zero_mode_energy;
    }

    test::Body body = test::small_sphere();
    tlsph::TlsphSolver solver;
    std::vector<Vec3> x = test::perturbed(body.cloud.positions, 0.1 * body.cloud.spacing);
};

TEST_F(OtherMaterial, ForcesAreTheNegativeGradientOfTheEnergy)
{
    std::vector<Vec3> forces(x.size());
    ASSERT_EQ(solver.evaluate(x, growth_time, forces).invalid_at, -1);
    const double h = 1e-5 * body.cloud.spacing;
    for (std::uint64_t direction = 0; direction < 5; ++direction)
    {
        std::vector<Vec3> above = x;
        std::vector<Vec3> below = x;
        double expected = 0.0;
        double size = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            const Vec3 d = test::random_vector(direction, i);
            above[i] += h * d;
            below[i] -= h * d;
            expected -= dot(forces[i], d);
            size += std::abs(dot(forces[i], d));
        }
        const double slope = (energy_at(above) - energy_at(below)) / (2.0 * h);
        // Round-off of an energy of some thousand over h, and h² times its third derivative.
        EXPECT_NEAR(slope, expected, 1e-7 * size);
    }
    test::expect_momenta_conserved(x, forces);
}

TEST_F(OtherMaterial, IsNotTheLawOfTheProgram)
{
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse known =
        tlsph::TlsphSolver(body.particles, body.tissue).evaluate(x, growth_time, forces);
    const mechanics::InternalResponse other = solver.evaluate(x, growth_time, forces);
    EXPECT_GT(std::abs(other.elastic_energy / known.elastic_energy - 1.0), 1e-4);
    // The same formulas compiled beside another law: the compiler contracts them differently.
    EXPECT_NEAR(other.smallest_J / known.smallest_J, 1.0, 1e-12);
    EXPECT_NEAR(other.stiffest_rate / known.stiffest_rate, 1.0, 1e-12);
}

TEST_F(OtherMaterial, MovesAndKeepsItsEnergy)
{
    std::vector<Vec3> forces(x.size());
    std::vector<Vec3> v(x.size());
    mechanics::InternalResponse response = solver.evaluate(x, growth_time, forces);
    const double start = response.elastic_energy + response.zero_mode_energy;
    const double dt = 0.1 * body.cloud.spacing / response.stiffest_rate;
    double kinetic = 0.0;
    for (int step = 0; step < 40; ++step)
    {
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            v[i] += (0.5 * dt / body.particles.volume[i]) * forces[i];
            x[i] += dt * v[i];
        }
        response = solver.evaluate(x, growth_time, forces);
        ASSERT_EQ(response.invalid_at, -1);
        kinetic = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            v[i] += (0.5 * dt / body.particles.volume[i]) * forces[i];
            kinetic += 0.5 * body.particles.volume[i] * squared_norm(v[i]);
        }
    }
    EXPECT_GT(kinetic, 0.05 * start);
    // The velocity Verlet scheme errs by (omega dt)² / 8 of the energy, here at most a per cent.
    EXPECT_NEAR((kinetic + response.elastic_energy + response.zero_mode_energy) / start, 1.0, 0.01);
}

} // namespace
} // namespace corticle
