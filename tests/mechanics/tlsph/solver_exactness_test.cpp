// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "momenta.hpp"

#include <gtest/gtest.h>

#include <numeric>

// What the discretisation does exactly, on an irregular cloud and at its surface too.
// Forces are measured against those of a strain of order one: a particle's volume over its spacing, times the modulus.

namespace corticle
{
namespace
{

using test::affine;
using test::largest_norm;
using test::perturbed;
using test::random_vector;
using test::small_sphere;

const Mat3 stretch{{{1.2, 0.05, -0.1}, {0.1, 0.9, 0.2}, {-0.15, 0.1, 1.1}}};

/// Round-off of F near the surface, where sums are of products of three coordinates instead of differences: they lose
/// about the square of block over support in digits.
constexpr double product_round_off = 1e-11;

double force_scale(const test::Body& body)
{
    return body.cloud.spacing * body.cloud.spacing;
}

TEST(TlsphExactness, RestIsFreeOfStrainAndForce)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(body.cloud.positions.size());
    const mechanics::InternalResponse response = solver.evaluate(body.cloud.positions, 0.0, forces);
    EXPECT_EQ(response.invalid_at, -1);
    EXPECT_EQ(response.barrier_count, 0);
    EXPECT_NEAR(response.smallest_J, 1.0, product_round_off);
    for (const Mat3& F : solver.deformation_gradients(body.cloud.positions))
    {
        EXPECT_LT(test::largest_difference(F, Mat3::identity()), product_round_off);
    }
    EXPECT_LT(largest_norm(forces), 5.0 * product_round_off * force_scale(body));
}

TEST(TlsphExactness, AffineMotionIsReproducedEverywhere)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const std::vector<Vec3> x = affine(body.cloud.positions, stretch, {3.0, -7.0, 2.0});
    for (const Mat3& F : solver.deformation_gradients(x))
    {
        EXPECT_LT(test::largest_difference(F, stretch), product_round_off);
    }
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, 0.0, forces);
    EXPECT_NEAR(response.smallest_J, determinant(stretch), product_round_off);
    // An affine motion has no zero-energy part: what remains is the round-off of sums as large as the elastic energy.
    EXPECT_LT(std::abs(response.zero_mode_energy), 1e-12 * response.elastic_energy);
}

TEST(TlsphExactness, RigidRotationCostsNothing)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 2.3);
    const std::vector<Vec3> x = affine(body.cloud.positions, Q, {1.0, 2.0, 3.0});
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, 0.0, forces);
    const double volume = std::accumulate(body.cloud.volumes.begin(), body.cloud.volumes.end(), 0.0);
    EXPECT_LT(std::abs(response.elastic_energy), 1e-13 * volume);
    EXPECT_LT(std::abs(response.zero_mode_energy), 1e-13 * volume);
    EXPECT_LT(largest_norm(forces), product_round_off * force_scale(body));
}

TEST(TlsphExactness, FreeIsotropicGrowthIsFreeOfForceAndStress)
{
    test::Body body = small_sphere();
    std::fill(body.tissue.normal.begin(), body.tissue.normal.end(), Vec3{}); // G = g I
    std::fill(body.tissue.theta.begin(), body.tissue.theta.end(), 1.0);
    const double t = 0.4;
    const double g = material::material_point(body.tissue.options, 1.0, 1.0, t).growth;
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const std::vector<Vec3> x = affine(body.cloud.positions, g * Mat3::identity());
    std::vector<Vec3> forces(x.size());
    const mechanics::InternalResponse response = solver.evaluate(x, t, forces);
    EXPECT_LT(largest_norm(forces), 10.0 * product_round_off * force_scale(body)); // moduli grow with g², to 3 here
    EXPECT_LT(std::abs(response.elastic_energy), 1e-12 * 8173.0);
    EXPECT_NEAR(response.smallest_J, g * g * g, 10.0 * product_round_off);
    // The volume is g³ times the old one because the surface is made of particles.
    std::vector<Vec3> surface;
    for (const std::int32_t i : body.cloud.surface_particles)
    {
        surface.push_back(x[static_cast<std::size_t>(i)]);
    }
    EXPECT_NEAR(enclosed_volume(surface, body.cloud.surface_triangles) / (g * g * g * 8173.38), 1.0, 1e-6);
}

TEST(TlsphExactness, BothMomentaAreConserved)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const std::vector<Vec3> x =
        perturbed(affine(body.cloud.positions, stretch, {5.0, 0.0, -3.0}), 0.1 * body.cloud.spacing);
    std::vector<Vec3> forces(x.size());
    ASSERT_EQ(solver.evaluate(x, 0.3, forces).invalid_at, -1);
    test::expect_momenta_conserved(x, forces);
}

TEST(TlsphExactness, OneAndTwoThreadsGiveTheSameBits)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const std::vector<Vec3> x = perturbed(body.cloud.positions, 0.1 * body.cloud.spacing);
    const int threads = thread_count();
    std::vector<Vec3> one(x.size());
    std::vector<Vec3> two(x.size());
    set_thread_count(1);
    const mechanics::InternalResponse by_one = solver.evaluate(x, 0.3, one);
    set_thread_count(2);
    const mechanics::InternalResponse by_two = solver.evaluate(x, 0.3, two);
    set_thread_count(threads);
    EXPECT_EQ(one, two);
    EXPECT_EQ(by_one.elastic_energy, by_two.elastic_energy);
    EXPECT_EQ(by_one.zero_mode_energy, by_two.zero_mode_energy);
    EXPECT_EQ(by_one.growth_power, by_two.growth_power);
    EXPECT_EQ(by_one.stiffest_rate, by_two.stiffest_rate);
    EXPECT_EQ(by_one.smallest_J_at, by_two.smallest_J_at);
}

TEST(TlsphExactness, StiffestRateIsTheWaveSpeedOverTheSmallestStretch)
{
    test::Body body = small_sphere();
    std::fill(body.tissue.theta.begin(), body.tissue.theta.end(), 0.0); // white matter everywhere, no growth
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(body.cloud.positions.size());
    const auto rate = [&](const Mat3& A)
    { return solver.evaluate(affine(body.cloud.positions, A), 0.0, forces).stiffest_rate; };
    const double c_p = material::wave_speed(body.tissue.options);
    // The bound is exact for uniaxial and for isotropic compression; the root of a cancelled variance costs half the
    // digits for the isotropic one.
    EXPECT_NEAR(rate(Mat3::diagonal(0.5, 1.0, 1.0)), c_p / 0.5, 1e-6);
    EXPECT_NEAR(rate(Mat3::diagonal(0.8, 0.8, 0.8)), c_p / 0.8, 1e-6);
    EXPECT_GE(rate(stretch), c_p);
}

TEST(TlsphExactness, AnInvertedParticleIsReported)
{
    const test::Body& body = small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(body.cloud.positions.size());
    EXPECT_EQ(solver.evaluate(affine(body.cloud.positions, Mat3::diagonal(-1, 1, 1)), 0.0, forces).invalid_at, 0);
    std::vector<Vec3> x = body.cloud.positions;
    x[1234].y = std::nan("");
    EXPECT_GE(solver.evaluate(x, 0.0, forces).invalid_at, 0);
}

TEST(Particles, APlaneIsRefusedByNameOfItsWorstParticle)
{
    Cloud cloud;
    cloud.spacing = 1.0;
    for (int k = 0; k < 400; ++k)
    {
        cloud.positions.push_back(Vec3{k % 20 * 1.0, k / 20 * 1.0, 0.0} +
                                  0.2 * cross(random_vector(3, static_cast<std::uint64_t>(k)), {0, 0, 1}));
        cloud.volumes.push_back(1.0);
    }
    try
    {
        tlsph::make_particles(cloud, cloud::find_pairs_within(cloud.positions, 2.5), {});
        FAIL() << "accepted";
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("ill-conditioned"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("worst particle "), std::string::npos) << error.what();
    }
}

TEST(Particles, ConditionNumber)
{
    EXPECT_NEAR(tlsph::condition_number(Mat3::diagonal(2.0, 8.0, 4.0)), 4.0, 1e-13);
    EXPECT_NEAR(tlsph::condition_number(3.0 * Mat3::identity()), 1.0, 1e-15);
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 0.7);
    EXPECT_NEAR(tlsph::condition_number(Q * Mat3::diagonal(1.0, 50.0, 7.0) * transpose(Q)), 50.0, 1e-10);
    EXPECT_GT(tlsph::condition_number(Mat3::diagonal(1.0, 1.0, -0.1)), 1e300);
}

} // namespace
} // namespace corticle
