// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/base/error.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

// What holds of particles alone, on an irregular cloud and at its surface too.

namespace corticle
{
namespace
{

using test::affine;
using test::random_vector;
using test::small_sphere;

const Mat3 stretch{{{1.2, 0.05, -0.1}, {0.1, 0.9, 0.2}, {-0.15, 0.1, 1.1}}};

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
