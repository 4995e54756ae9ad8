// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/remodelling_view.hpp"
#include "mechanics/energy_gradient.hpp"
#include "mechanics/methods.hpp"

#include <gtest/gtest.h>

// Tissue with a history, by both methods: forces hold the history and are the gradient of the energy then.

namespace corticle
{
namespace
{

constexpr double growth_time = 0.3;

std::unique_ptr<mechanics::Discretization> solver_of(const test::OfParticles& body, const material::Tissue& tissue)
{
    return std::make_unique<tlsph::TlsphSolver>(body.body.particles, tissue);
}
std::unique_ptr<mechanics::Discretization> solver_of(const test::OfTets& body, const material::Tissue& tissue)
{
    return std::make_unique<fem::FemSolver>(body.body.elements, tissue);
}

/// Histories with nothing at rest in them.
struct Histories
{
    explicit Histories(std::size_t points) : strain(6 * points), growth(points), length(points)
    {
        for (std::size_t i = 0; i < points; ++i)
        {
            Mat3 F = Mat3::identity();
            for (std::uint64_t c = 0; c < 3; ++c)
            {
                F.column[c] += 0.2 * test::random_vector(21, 3 * i + c);
            }
            const Mat3 C_v = material::flowed(Mat3::identity(), F, determinant(F), 0.5);
            for (std::size_t k = 0; k < material::strain_size; ++k)
            {
                strain[k * points + i] = C_v(material::strain_entries[k][0], material::strain_entries[k][1]);
            }
            growth[i] = 1.0 + 0.1 * hash_uniform(22, i);
            length[i] = 0.9 + 0.1 * hash_uniform(23, i);
        }
    }
    std::vector<double> strain, growth, length;
};

template <class Body>
class WithHistory : public testing::Test
{
  protected:
    WithHistory()
    {
        test::OwnTissue& tissue = body.tissue();
        for (std::size_t i = 0; i < points; ++i)
        {
            tissue.fibre.push_back(normalized(test::random_vector(24, i)));
            tissue.white_share.push_back(1.0 - 0.5 * tissue.theta[i]);
        }
        view.points = points;
        view.step.relaxation_share = 0.5;
        view.step.has_fibres = true;
        view.step.fibre_stiffness = 1.0;
        view.step.tension_before = 0.1;
        view.step.tension = 0.1;
        view.before = {found.strain.data(), found.growth.data(), found.length.data()};
        view.after = {tried.strain.data(), tried.growth.data(), tried.length.data()};
        material::Tissue viewed = tissue;
        viewed.remodelling = &view;
        solver = solver_of(body, viewed);
    }

    mechanics::InternalResponse response_at(std::span<const Vec3> positions, std::vector<Vec3>& forces)
    {
        forces.resize(positions.size());
        const mechanics::InternalResponse response = solver->evaluate(positions, growth_time, forces);
        EXPECT_EQ(response.invalid_at, -1);
        return response;
    }
    double energy_at(std::span<const Vec3> positions)
    {
        std::vector<Vec3> forces;
        const mechanics::InternalResponse response = response_at(positions, forces);
        return response.elastic_energy + response.zero_mode_energy;
    }

    void expect_gradient(std::span<const Vec3> at, double tolerance)
    {
        std::vector<Vec3> forces;
        response_at(at, forces);
        test::expect_energy_gradient(
            at, forces, [this](std::span<const Vec3> positions) { return energy_at(positions); }, 1e-5 * body.spacing(),
            tolerance);
    }

    Body body;
    std::size_t points = body.tissue().theta.size();
    Histories found{points};
    Histories tried{points};
    material::RemodellingView view;
    std::unique_ptr<mechanics::Discretization> solver;
    std::vector<Vec3> x = test::perturbed(body.X(), 0.1 * body.spacing());
};

using Methods = testing::Types<test::OfParticles, test::OfTets>;
TYPED_TEST_SUITE(WithHistory, Methods);

TYPED_TEST(WithHistory, ForcesAreTheNegativeGradientOfTheEnergy)
{
    // Round-off of an energy of some thousand over h, and h² times its third derivative.
    this->expect_gradient(this->x, 1e-7);
}

TYPED_TEST(WithHistory, AStepReleasesTheEnergyThatIsMissingAfterIt)
{
    const double before = this->energy_at(this->x);
    material::RemodellingStep& step = this->view.step;
    step.elapsed = 1e-4;
    step.relaxation = 1e-3;
    step.growth = 1e-4;
    step.fibre_growth = 1e-3;
    step.tension = 0.1002;
    std::vector<Vec3> forces;
    const mechanics::InternalResponse after = this->response_at(this->x, forces);
    const double missing = before - after.elastic_energy - after.zero_mode_energy;
    EXPECT_GT(std::abs(missing), 1e-6 * before);
    // The volumetric energy of nodes is taken to first order in the step.
    EXPECT_NEAR(after.released / missing, 1.0, 1e-3);
    // Taken, the step leaves the same forces.
    step.elapsed = 0.0;
    step.tension_before = step.tension;
    this->view.before = {this->tried.strain.data(), this->tried.growth.data(), this->tried.length.data()};
    std::vector<Vec3> again;
    EXPECT_EQ(this->response_at(this->x, again).elastic_energy, after.elastic_energy);
    EXPECT_EQ(again, forces);
}

using WithHistoryOfTets = WithHistory<test::OfTets>;

TEST_F(WithHistoryOfTets, IsExtrapolatedWhereTetsAreInverted)
{
    body.tissue().options.barrier_J = 0.0;
    material::Tissue viewed = body.tissue();
    viewed.remodelling = &view;
    solver = solver_of(body, viewed);
    x = test::perturbed(body.X(), 0.35);
    std::vector<Vec3> forces;
    EXPECT_GT(response_at(x, forces).extrapolated_count, 0);
    expect_gradient(x, 1e-6);
}

} // namespace
} // namespace corticle
