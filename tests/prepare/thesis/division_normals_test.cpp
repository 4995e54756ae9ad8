// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/division_normals.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/random.hpp"
#include "corticle/geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle
{
namespace
{

/// Points at random in a ball about the origin.
std::vector<Vec3> ball_points(double radius, std::uint64_t tries)
{
    std::vector<Vec3> points;
    for (std::uint64_t k = 0; k < tries; ++k)
    {
        const auto coordinate = [&](std::uint64_t axis)
        { return radius * (2.0 * hash_uniform(4, 3 * k + axis) - 1.0); };
        const Vec3 X{coordinate(0), coordinate(1), coordinate(2)};
        if (norm(X) < radius)
        {
            points.push_back(X);
        }
    }
    return points;
}

double angle(const Vec3& a, const Vec3& b)
{
    return 180.0 / std::numbers::pi * std::acos(std::clamp(dot(a, b), -1.0, 1.0));
}

TEST(DivisionNormals, PiecesOfABallAreEqual)
{
    const Vec3 centre{1, 2, 3};
    const std::vector<Vec3> points = ball_points(1.0, 60000);
    for (const std::int32_t divisions : {2, 4, 8, 16})
    {
        std::vector<double> held(divisions, 0.0);
        for (const Vec3& X : points)
        {
            const std::int32_t piece = prepare::division_of(centre + X, divisions, centre);
            ASSERT_GE(piece, 0);
            ASSERT_LT(piece, divisions);
            held[piece] += 1.0;
        }
        for (const double count : held)
        {
            const double expected = static_cast<double>(points.size()) / divisions;
            EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected)); // five standard deviations
        }
    }
    for (const Vec3& X : points) // eight are the octants
    {
        const int octant = (X.y < 0.0 ? (X.x < 0.0 ? 2 : 3) : (X.x < 0.0 ? 1 : 0)) * 2 + (X.z < 0.0 ? 1 : 0);
        ASSERT_EQ(prepare::division_of(X, 8, {}), octant);
    }
}

TEST(DivisionNormals, OnASphereAreWithinTheSizeOfATriangle)
{
    // All normal lines pass close by the centre (through it, if their points were the circumcentres of the triangles),
    // so the error is about the angle to the nearest of them in the piece. Edges of about 1 on a radius of 10 are
    // circumradii of 3.3 degrees; beside a border of the piece, where the triangle across is not allowed, one triangle
    // more.
    const TriangleMesh surface = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 1.0);
    const prepare::NormalLines lines = prepare::triangle_normal_lines(surface);
    const std::vector<Vec3> particles = ball_points(10.0, 4000);
    for (const std::int32_t divisions : {4, 8, 16})
    {
        const std::vector<Vec3> normals = prepare::division_normals(particles, lines, divisions, {});
        double sum = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            const double error = angle(normals[i], normalized(particles[i]));
            sum += norm(particles[i]) > 1.0 ? error : 0.0;
            largest = norm(particles[i]) > 1.0 ? std::max(largest, error) : largest;
        }
        const double mean = sum / static_cast<double>(particles.size());
        EXPECT_GT(mean, 0.5);
        EXPECT_LT(mean, 3.0);
        EXPECT_LT(largest, 10.0);
    }
}

TEST(DivisionNormals, AreTheNearestLineOfTheOwnPieceOnly)
{
    // The line along z passes through the particle, but belongs to the other half.
    const prepare::NormalLines lines{{{1, 1, 5}, {1, 1, -5}}, {{0.6, 0, 0.8}, {0, 0, -1}}};
    const std::vector<Vec3> above{{1, 1, 2}};
    EXPECT_EQ(prepare::division_normals(above, lines, 2, {})[0], (Vec3{0.6, 0, 0.8}));
    const std::vector<Vec3> below{{1, 1, -2}};
    EXPECT_EQ(prepare::division_normals(below, lines, 2, {})[0], (Vec3{0, 0, -1}));
    EXPECT_THROW(prepare::division_normals(std::vector<Vec3>{{2, 3, 2}}, lines, 4, {1, 2, 0}),
                 InputError); // no line there
}

TEST(DivisionNormals, OffTheSphereTakeLinesOfFarParts)
{
    // A slab, and a particle under its top: the line of its rim, 20 away, passes nearer than that of the top above.
    const prepare::NormalLines lines{{{20, 0, 5}, {3, 0.3, 6}}, {{1, 0, 0}, {0, 0, 1}}};
    const std::vector<Vec3> particles{{3, 0.1, 5.05}, {3, 0.3, 5.5}};
    const std::vector<Vec3> normals = prepare::division_normals(particles, lines, 8, {0, -1, 0});
    EXPECT_EQ(normals[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(normals[1], (Vec3{0, 0, 1}));
}

TEST(DivisionNormals, RefuseNonsense)
{
    const prepare::NormalLines lines = prepare::triangle_normal_lines(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.4));
    const std::vector<Vec3> particles{{0.5, 0.1, 0.2}};
    for (const std::int32_t divisions : {-4, 0, 1, 7, 2000})
    {
        EXPECT_THROW(prepare::division_normals(particles, lines, divisions, {}), InputError) << divisions;
    }
}

} // namespace
} // namespace corticle
