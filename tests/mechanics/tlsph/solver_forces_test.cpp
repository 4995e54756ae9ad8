// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/neo_hookean.hpp"
#include "corticle/mechanics/tlsph/kernel.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// One choice of tissue and deformation; the cloud is always the irregular sphere, with growth and a perturbation.
struct Situation
{
    material::BulkRule bulk;
    double compression; ///< all positions are scaled by it; 0.6 makes the barrier act
    double t;
};

using Coefficients = Eigen::Matrix<double, 3, 9>;

Eigen::Vector3d eigen(const Vec3& v)
{
    return {v.x, v.y, v.z};
}
Eigen::Matrix3d eigen(const Mat3& m)
{
    Eigen::Matrix3d result;
    result << eigen(m.column[0]), eigen(m.column[1]), eigen(m.column[2]);
    return result;
}
Mat3 matrix_of(const Eigen::Matrix3d& m)
{
    return {{{m(0, 0), m(1, 0), m(2, 0)}, {m(0, 1), m(1, 1), m(2, 1)}, {m(0, 2), m(1, 2), m(2, 2)}}};
}

/// The functions of the fit.
Eigen::Matrix<double, 9, 1> functions(const Vec3& X)
{
    Eigen::Matrix<double, 9, 1> p;
    p << X.x, X.y, X.z, X.x * X.x, X.x * X.y, X.x * X.z, X.y * X.y, X.y * X.z, X.z * X.z;
    return p;
}

/// Their slopes where the gradient of particle i is taken.
Eigen::Matrix<double, 9, 3> slope_at(const tlsph::Particles& p, std::size_t i)
{
    const std::int32_t group = p.enriched.group[i / 8];
    const int lane = static_cast<int>(i % 8);
    const auto coordinate = [&](int axis) { return group < 0 ? 0.0 : p.enriched.fits[group].at[axis][lane]; };
    const Vec3 at{coordinate(0), coordinate(1), coordinate(2)};
    Eigen::Matrix<double, 9, 3> slope;
    slope << 1, 0, 0, 0, 1, 0, 0, 0, 1, 2 * at.x, 0, 0, at.y, at.x, 0, at.z, 0, at.x, 0, 2 * at.y, 0, 0, at.z, at.y, 0,
        0, 2 * at.z;
    return slope;
}

Eigen::MatrixXd inverse_of_fit(const tlsph::Particles& p, std::size_t i)
{
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(9, 9);
    const std::int32_t group = p.enriched.group[i / 8];
    if (group < 0)
    {
        inverse.topLeftCorner<3, 3>() = eigen(p.correction[i]);
        return inverse;
    }
    for (int row = 0, place = 0; row < 9; ++row)
    {
        for (int column = row; column < 9; ++column)
        {
            inverse(row, column) = inverse(column, row) =
                p.enriched.fits[group].inverse[place++][static_cast<int>(i % 8)];
        }
    }
    return inverse;
}

class TlsphForces : public testing::TestWithParam<Situation>
{
  protected:
    TlsphForces() : body(test::small_sphere())
    {
        body.tissue.options.bulk = GetParam().bulk;
        for (std::size_t i = 0; i < body.tissue.regional_rate.size(); ++i)
        {
            body.tissue.regional_rate[i] = 0.7 + 0.5 * hash_uniform(5, i);
        }
        const Mat3 A = GetParam().compression * Mat3{{{1.0, 0.05, -0.1}, {0.1, 0.95, 0.1}, {-0.1, 0.1, 1.05}}};
        x = test::perturbed(test::affine(body.cloud.positions, A), 0.05 * body.cloud.spacing);
    }

    double energy(tlsph::TlsphSolver& solver, double t)
    {
        const mechanics::InternalResponse response = solver.evaluate(x, t, scratch);
        return response.elastic_energy + response.zero_mode_energy;
    }

    test::Body body;
    std::vector<Vec3> x;
    std::vector<Vec3> scratch = std::vector<Vec3>(body.cloud.positions.size());
};

TEST_P(TlsphForces, AreMinusTheGradientOfTheEnergy)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, GetParam().t, forces);
    ASSERT_EQ(response.invalid_at, -1);
    EXPECT_EQ(response.barrier_count > 0, GetParam().compression < 0.7);
    const double scale = test::largest_norm(forces);
    const auto count = static_cast<std::int32_t>(x.size());
    const auto& surface = body.cloud.surface_particles;
    for (const std::int32_t particle :
         {0, count / 3, count / 2, count - 1, surface[0], surface[surface.size() / 2], surface[surface.size() - 1]})
    {
        const auto i = static_cast<std::size_t>(particle);
        for (int axis = 0; axis < 3; ++axis)
        {
            const double h = 1e-4 * body.cloud.spacing;
            const double at = x[i][axis];
            x[i][axis] = at + h;
            const double above = energy(solver, GetParam().t);
            x[i][axis] = at - h;
            const double below = energy(solver, GetParam().t);
            x[i][axis] = at;
            // Truncation is h² ~ 1e-8 relative, round-off of an energy of some thousand over h about 1e-8.
            EXPECT_NEAR(forces[i][axis], -(above - below) / (2.0 * h), 1e-6 * scale) << "particle " << particle;
        }
    }
}

TEST_P(TlsphForces, GrowthPowerIsTheDerivativeOfTheEnergyInTime)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const double power = solver.evaluate(x, GetParam().t, scratch).growth_power;
    const double h = 1e-5;
    const double slope = (energy(solver, GetParam().t + h) - energy(solver, GetParam().t - h)) / (2.0 * h);
    // A particle that crosses the onset of the barrier within h changes the second derivative, no more.
    EXPECT_NEAR(slope / power, 1.0, 1e-6);
}

TEST_P(TlsphForces, AgreeWithPlainLoops)
{
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, GetParam().t, forces);
    const tlsph::Particles& p = body.particles;
    std::vector<Coefficients> Z(x.size());
    std::vector<double> zeta(x.size());
    double elastic_energy = 0.0;
    double zero_mode_energy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const Eigen::MatrixXd fit = inverse_of_fit(p, i);
        Coefficients moments = Coefficients::Zero();
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            moments += p.pairs.weight[k] * eigen(x[j] - x[i]) * functions(p.X[j] - p.X[i]).transpose();
        }
        const Coefficients a = moments * fit;
        const Mat3 F = matrix_of(a * slope_at(p, i));
        const auto& tissue = body.tissue;
        const material::MaterialPoint point =
            material::material_point(tissue.options, tissue.theta[i], tissue.regional_rate[i], GetParam().t);
        const double g = point.growth;
        const Mat3 G = g * Mat3::identity() + (1.0 - g) * outer(tissue.normal[i], tissue.normal[i]);
        const material::NeoHookean law{tissue.options.barrier_J};
        const material::ElasticResponse elastic =
            material::elastic_response(law, point.shear_modulus, point.bulk_modulus, F * inverse(G));
        const Mat3 P = determinant(G) * (elastic.stress * transpose(inverse(G)));
        zeta[i] = p.options.zeta * point.shear_modulus * g * g;
        Z[i] = (p.volume[i] * eigen(P) * slope_at(p, i).transpose() - zeta[i] * moments) * fit;
        elastic_energy += p.volume[i] * determinant(G) * (elastic.deviatoric_energy + elastic.volumetric_energy);
        double squared_lengths = 0.0;
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            squared_lengths +=
                p.pairs.weight[k] * squared_norm(x[p.pairs.neighbor(static_cast<std::int64_t>(i), k)] - x[i]);
        }
        zero_mode_energy += 0.5 * zeta[i] * (squared_lengths - moments.cwiseProduct(a).sum());
    }
    // Sums of some thousand terms in another order.
    EXPECT_NEAR(response.elastic_energy / elastic_energy, 1.0, 1e-11);
    EXPECT_NEAR(response.zero_mode_energy / zero_mode_energy, 1.0,
                1e-9); // there a difference of sums 100 times as large
    const double scale = test::largest_norm(forces);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        Vec3 force;
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            const Vec3 X_ij = p.X[j] - p.X[i];
            const Eigen::Vector3d pull = Z[i] * functions(X_ij) - Z[j] * functions(-X_ij);
            force += w * (Vec3{pull[0], pull[1], pull[2]} + (zeta[i] + zeta[j]) * (x[j] - x[i]));
        }
        // Products of three coordinates lose about the square of block over support in digits.
        ASSERT_LT(norm(forces[i] - force), 1e-11 * scale) << "particle " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Tissues, TlsphForces,
                         testing::Values(Situation{material::BulkRule::per_tissue, 1.0, 0.3},
                                         Situation{material::BulkRule::uniform, 1.1, 0.25},
                                         Situation{material::BulkRule::per_tissue, 0.6, 0.4}));

TEST(Particles, WeightsAreSymmetricAndThoseOfTheKernel)
{
    const tlsph::Particles& p = test::small_sphere().particles;
    const double support = p.options.support * p.spacing;
    for (std::size_t i = 0; i < p.X.size(); ++i)
    {
        for (std::int64_t k = p.pairs.begin[i]; k < p.pairs.begin[i + 1]; ++k)
        {
            const auto j = static_cast<std::size_t>(p.pairs.neighbor(static_cast<std::int64_t>(i), k));
            const double w = p.pairs.weight[k];
            std::int64_t back = p.pairs.begin[j];
            while (back < p.pairs.begin[j + 1] &&
                   p.pairs.neighbor(static_cast<std::int64_t>(j), back) != static_cast<std::int32_t>(i))
            {
                ++back;
            }
            ASSERT_LT(back, p.pairs.begin[j + 1]);
            ASSERT_EQ(p.pairs.weight[k], p.pairs.weight[back]);
            const double exact = p.volume[i] * p.volume[j] * tlsph::pair_weight(norm(p.X[j] - p.X[i]), support);
            ASSERT_NEAR(w, exact, 1e-7 * exact); // half a unit in the last place of a float is 6e-8
        }
    }
}

} // namespace
} // namespace corticle
