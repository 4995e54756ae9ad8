// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/thesis/printed_solver.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/material/neo_hookean.hpp"
#include "corticle/mechanics/tlsph/kernel.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

constexpr double growth_time = 0.3;

class PrintedForces : public testing::Test
{
  protected:
    PrintedForces() : body(test::small_sphere())
    {
        const Mat3 A{{{1.0, 0.05, -0.1}, {0.1, 0.95, 0.1}, {-0.1, 0.1, 1.05}}};
        x = test::perturbed(test::affine(body.cloud.positions, A), 0.05 * body.cloud.spacing);
        v = test::perturbed(std::vector<Vec3>(x.size()), 0.1);
    }

    std::vector<Vec3> forces_of(mechanics::Discretization& solver)
    {
        std::vector<Vec3> forces(x.size());
        response = solver.evaluate(x, growth_time, forces);
        EXPECT_EQ(response.invalid_at, -1);
        return forces;
    }

    Mat3 growth(std::size_t i) const
    {
        const double g = body.tissue.point(i, growth_time).growth;
        return g * Mat3::identity() + (1.0 - g) * outer(body.tissue.normal[i], body.tissue.normal[i]);
    }

    /// P of thesis eq. 23 of this F, by the Cauchy stress it prints.
    Mat3 printed_stress(std::size_t i, const Mat3& F) const
    {
        const material::MaterialPoint point = body.tissue.point(i, growth_time);
        const double J = determinant(F);
        const Mat3 B = F * transpose(F);
        const Mat3 sigma = (point.shear_modulus * std::pow(J, -5.0 / 3.0)) * (B - (trace(B) / 3.0) * Mat3::identity()) +
                           (point.bulk_modulus * (J - 1.0)) * Mat3::identity();
        return J * (sigma * transpose(inverse(F)));
    }

    test::Body body;
    std::vector<Vec3> x;
    std::vector<Vec3> v;
    mechanics::InternalResponse response;
};

double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        largest = std::max(largest, norm(a[i] - b[i]));
    }
    return largest;
}

TEST_F(PrintedForces, WithEverythingPutRightAreThoseOfTheMainSolver)
{
    const tlsph::Particles linear = test::without_enrichment(body.particles);
    tlsph::TlsphSolver ours(linear, body.tissue);
    const std::vector<Vec3> expected = forces_of(ours);
    const mechanics::InternalResponse main = response;
    thesis::PrintedSolver printed(
        body.particles, body.tissue,
        {thesis::GrowthEntry::divided, thesis::ForceForm::conservative, thesis::KernelGradient::corrected, 0.0, 0.0});
    const std::vector<Vec3> forces = forces_of(printed);
    // Sums of products of coordinates instead of differences lose about the square of body over support in digits.
    EXPECT_LT(largest_difference(forces, expected), 1e-11 * test::largest_norm(expected));
    EXPECT_NEAR(response.elastic_energy / main.elastic_energy, 1.0, 1e-11);
    EXPECT_NEAR(response.zero_mode_energy / main.zero_mode_energy, 1.0, 1e-9);
    EXPECT_NEAR(response.growth_power / main.growth_power, 1.0, 1e-9);
    EXPECT_NEAR(response.stiffest_rate / main.stiffest_rate, 1.0, 1e-11);
    EXPECT_NEAR(response.smallest_J / main.smallest_J, 1.0, 1e-11);
    EXPECT_LT(test::largest_difference(printed.deformation_gradients(x)[17], ours.deformation_gradients(x)[17]), 1e-11);
    std::vector<Vec3> untouched = forces;
    EXPECT_EQ(printed.add_viscous_forces(x, v, untouched), 0.0);
    EXPECT_EQ(untouched, forces);
}

/// Every choice of force and gradient against plain loops over thesis eqs. 9, 10, 22 and 23.
TEST_F(PrintedForces, AgreeWithPlainLoops)
{
    const tlsph::Particles& p = body.particles;
    body.particles.options.zeta = 0.0;
    body.tissue.options.barrier_J = 0.0;
    for (const thesis::KernelGradient gradient :
         {thesis::KernelGradient::plain, thesis::KernelGradient::displacement, thesis::KernelGradient::corrected})
    {
        std::vector<Mat3> C(x.size());
        std::vector<Mat3> P(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            Mat3 F;
            Mat3 shape;
            for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
            {
                const std::int32_t j = p.pairs.neighbor(i, k);
                const Vec3 X_ij = p.X[j] - p.X[i];
                const double weight = double{p.pairs.weight[k]} / p.volume[i]; // V_j omega
                F += weight * outer(x[j] - x[i], X_ij);
                shape += weight * outer(X_ij, X_ij);
            }
            C[i] = gradient == thesis::KernelGradient::corrected ? inverse(shape) : Mat3::identity();
            F = gradient == thesis::KernelGradient::displacement ? Mat3::identity() + F - shape : F * C[i];
            P[i] = printed_stress(i, F * growth(i));
        }
        for (const thesis::ForceForm form : {thesis::ForceForm::difference, thesis::ForceForm::conservative})
        {
            std::vector<Vec3> expected(x.size());
            for (std::size_t i = 0; i < x.size(); ++i)
            {
                for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
                {
                    const std::int32_t j = p.pairs.neighbor(i, k);
                    const Vec3 X_ij = p.X[j] - p.X[i];
                    const Mat3 S =
                        form == thesis::ForceForm::difference ? (P[j] - P[i]) * C[i] : P[j] * C[j] + P[i] * C[i];
                    expected[i] += double{p.pairs.weight[k]} * (S * X_ij);
                }
            }
            thesis::PrintedSolver solver(p, body.tissue, {thesis::GrowthEntry::multiplied, form, gradient, 0.0, 0.0});
            EXPECT_LT(largest_difference(forces_of(solver), expected), 1e-11 * test::largest_norm(expected));
        }
    }
}

TEST_F(PrintedForces, DeformationGradientAtRestIsOfNoUseNearTheSurface)
{
    thesis::PrintedSolver solver(body.particles, body.tissue, {});
    const std::vector<Mat3> F = solver.deformation_gradients(body.cloud.positions);
    const auto surface = static_cast<std::size_t>(body.cloud.surface_particles[0]);
    const auto deepest =
        std::max_element(body.tissue.depth.begin(), body.tissue.depth.end()) - body.tissue.depth.begin();
    // Half of the ball about a particle on the surface is empty.
    EXPECT_LT(determinant(F[surface]), 0.5);
    EXPECT_NEAR(determinant(F[deepest]), 1.0, 0.2);
}

TEST_F(PrintedForces, FromDifferencesOfStressDoNotConserveMomentum)
{
    const auto total = [&](thesis::ForceForm form)
    {
        thesis::PrintedSolver solver(body.particles, body.tissue,
                                     {thesis::GrowthEntry::divided, form, thesis::KernelGradient::plain, 0.0, 0.0});
        Vec3 sum;
        for (const Vec3& force : forces_of(solver))
        {
            sum += force;
        }
        return norm(sum) / test::largest_norm(forces_of(solver));
    };
    EXPECT_GT(total(thesis::ForceForm::difference), 0.1);
    EXPECT_LT(total(thesis::ForceForm::conservative), 1e-10);
}

TEST_F(PrintedForces, GrowthPowerIsTheDerivativeOfTheEnergyInTime)
{
    thesis::PrintedSolver solver(body.particles, body.tissue, {});
    std::vector<Vec3> scratch(x.size());
    const auto energy = [&](double t)
    {
        const mechanics::InternalResponse at = solver.evaluate(x, t, scratch);
        return at.elastic_energy + at.zero_mode_energy;
    };
    const double h = 1e-5;
    const double slope = (energy(growth_time + h) - energy(growth_time - h)) / (2.0 * h);
    EXPECT_NEAR(slope / solver.evaluate(x, growth_time, scratch).growth_power, 1.0, 1e-6);
}

TEST_F(PrintedForces, ViscosityIsThatOfEquationSeven)
{
    const thesis::ThesisOptions options;
    thesis::PrintedSolver solver(body.particles, body.tissue, options);
    std::vector<Vec3> forces(x.size());
    const double power = solver.add_viscous_forces(x, v, forces);
    const tlsph::Particles& p = body.particles;
    const double h = tlsph::support_mm(p.options, p.spacing);
    const auto speed = [&](std::size_t i)
    {
        const material::MaterialPoint point = body.tissue.point(i, 0.0);
        return std::sqrt(point.bulk_modulus + 4.0 / 3.0 * point.shear_modulus);
    };
    std::vector<Vec3> expected(x.size());
    double expected_power = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(i, k));
            const Vec3 x_ij = x[j] - x[i];
            const double phi = h * dot(v[j] - v[i], x_ij) / (squared_norm(x_ij) + 0.01 * h * h);
            if (phi < 0.0)
            {
                const double stress =
                    -options.viscosity_alpha * 0.5 * (speed(i) + speed(j)) * phi + options.viscosity_beta * phi * phi;
                expected[i] -= (double{p.pairs.weight[k]} * stress) * (p.X[j] - p.X[i]);
            }
        }
        expected_power -= dot(expected[i], v[i]);
    }
    EXPECT_LT(largest_difference(forces, expected), 2e-5 * test::largest_norm(expected)); // single precision
    EXPECT_NEAR(power / expected_power, 1.0, 2e-5);
    EXPECT_GT(power, 0.0);
}

TEST_F(PrintedForces, AreTheSameBitsWithOneThreadAndTwo)
{
    thesis::PrintedSolver solver(body.particles, body.tissue, {});
    const int threads = thread_count();
    std::vector<std::vector<Vec3>> results;
    for (const int count : {1, 2})
    {
        set_thread_count(count);
        results.push_back(forces_of(solver));
        solver.add_viscous_forces(x, v, results.back());
    }
    set_thread_count(threads);
    EXPECT_EQ(results[0], results[1]);
}

TEST(NeighborGroups, HoldEveryPairOnceAndZerosElsewhere)
{
    const tlsph::Particles& p = test::small_sphere().particles;
    const thesis::NeighborGroups groups = thesis::group_neighbors(p.pairs);
    std::int64_t found = 0;
    for (std::int64_t i = 0; i < std::ssize(p.X); ++i)
    {
        const std::int64_t group = i / thesis::NeighborGroups::size;
        std::int64_t entry = p.pairs.begin[i];
        for (std::int64_t k = groups.begin[group]; k < groups.begin[group + 1]; ++k)
        {
            const float weight = groups.weight[thesis::NeighborGroups::size * k + i % thesis::NeighborGroups::size];
            if (entry < p.pairs.begin[i + 1] && p.pairs.neighbor(i, entry) == groups.index[k])
            {
                EXPECT_EQ(weight, p.pairs.weight[entry++]);
                ++found;
            }
            else
            {
                EXPECT_EQ(weight, 0.0F);
            }
        }
    }
    EXPECT_EQ(found, p.pairs.begin.back());
}

} // namespace
} // namespace corticle
