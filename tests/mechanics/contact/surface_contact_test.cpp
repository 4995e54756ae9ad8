// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/surface_contact.hpp"

#include "corticle/base/random.hpp"
#include "mechanics/contact/banks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

// Spacing 1: surfaces repel below dhat = 0.3.

namespace corticle
{
namespace
{

using test::Banks;

constexpr double frequency = 3.0;
constexpr double stiffness = 0.2;

contact::SurfaceContact contact_of(const Banks& rest)
{
    return {rest.mesh.triangles, rest.mesh.vertices, rest.masses(), 1.0, frequency, {true, 0.3, stiffness}};
}

struct Evaluated
{
    contact::ContactResponse response;
    std::vector<Vec3> forces;
    double energy = 0.0;
};

Evaluated evaluate(contact::SurfaceContact& contact, const std::vector<Vec3>& x)
{
    Evaluated result;
    result.forces.resize(x.size());
    result.response = contact.evaluate(x, result.forces);
    result.energy = contact.energy();
    return result;
}

Vec3 sum(std::span<const Vec3> forces)
{
    Vec3 total;
    for (const Vec3& f : forces)
    {
        total += f;
    }
    return total;
}

TEST(SurfaceContact, BanksRepelBelowTheActivationDistanceOnly)
{
    const Banks far(2.0);
    contact::SurfaceContact contact = contact_of(far);
    for (const double gap : {0.31, 0.5, 1.5})
    {
        const Evaluated apart = evaluate(contact, Banks(gap).mesh.vertices);
        EXPECT_EQ(apart.response.active, 0);
        EXPECT_EQ(apart.energy, 0.0);
        for (const Vec3& f : apart.forces)
        {
            EXPECT_EQ(f, Vec3{});
        }
    }
    double weaker = 0.0;
    for (const double gap : {0.29, 0.2, 0.1, 0.01})
    {
        const Evaluated near = evaluate(contact, Banks(gap).mesh.vertices);
        const Vec3 lower = sum(std::span(near.forces).first(far.lower_count));
        const Vec3 upper = sum(std::span(near.forces).subspan(far.lower_count));
        EXPECT_GT(upper.z, weaker);
        weaker = upper.z;
        EXPECT_LT(norm(lower + upper), 1e-14 * norm(upper) * 100.0); // a hundred pairs
        EXPECT_LT(std::hypot(upper.x, upper.y), 0.1 * upper.z);      // edges are a little rough to each other
        for (std::size_t k = 0; k < near.forces.size(); ++k)
        {
            EXPECT_GE((k < far.lower_count ? -1.0 : 1.0) * near.forces[k].z, -1e-14);
        }
    }
}

/// One vertex, number 3 and tip of a triangle that leads away, above the centroid of another.
std::vector<Vec3> tip_over_triangle(double height)
{
    return {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, height}, {1, 0, 5}, {0, 1, 5}};
}

contact::SurfaceContact tip_contact()
{
    return {std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}},
            tip_over_triangle(2.0),
            {1.0, 2.0, 4.0, 0.5, 1.0, 1.0},
            1.0,
            frequency,
            {true, 0.3, stiffness}};
}

TEST(SurfaceContact, RepelsWithTheBarrierOfItsMass)
{
    contact::SurfaceContact contact = tip_contact();
    const Evaluated result = evaluate(contact, tip_over_triangle(0.1));
    const double k = stiffness * 0.5 * frequency * frequency; // of the vertex, whose mass is 0.5
    const double least = 0.02 * 0.3;
    const double room = 0.1 - least;
    const double at_rest = 0.3 - least;
    const double force = k * 0.3 * (at_rest / room - 1.0);
    EXPECT_EQ(result.response.active, 1);
    EXPECT_LT(norm(result.forces[3] - Vec3{0, 0, force}), 1e-13);
    EXPECT_LT(norm(result.forces[1] + Vec3{0, 0, force / 3.0}), 1e-13);
    EXPECT_NEAR(result.energy, k * 0.3 * (at_rest * std::log(at_rest / room) - at_rest + room), 1e-14);
}

TEST(SurfaceContact, TheForceGrowsWithoutBoundTowardsTheLeastDistance)
{
    contact::SurfaceContact contact = tip_contact();
    const double least = 0.02 * 0.3;
    double before = 0.0;
    for (const double room : {1e-1, 1e-2, 1e-3, 1e-4})
    {
        const double force = evaluate(contact, tip_over_triangle(least + room)).forces[3].z;
        EXPECT_GT(force, 1.9 * before);
        before = force;
    }
    EXPECT_GT(before, 1000.0 * stiffness * 0.5 * frequency * frequency * 0.3);
}

TEST(SurfaceContact, TheRateIsThatOfALoneSpring)
{
    contact::SurfaceContact contact = tip_contact();
    EXPECT_EQ(evaluate(contact, tip_over_triangle(0.4)).response.largest_rate, 0.0);
    for (const double height : {0.29, 0.1, 0.03, 0.01})
    {
        const double room = height - 0.006;
        const double k = stiffness * 0.5 * frequency * frequency * 0.3 * 0.294 / (room * room);
        const double mass = 1.0 / (1.0 / 0.5 + (1.0 + 1.0 / 2.0 + 1.0 / 4.0) / 9.0);
        EXPECT_NEAR(evaluate(contact, tip_over_triangle(height)).response.largest_rate / std::sqrt(k / mass), 1.0,
                    1e-12);
    }
}

/// Bound of the largest eigenvalue of the stiffness matrix over the masses, by the power method on differences of the
/// forces.
TEST(SurfaceContact, TheRateBoundsThatOfManyPairs)
{
    const Banks rest(2.0);
    contact::SurfaceContact contact = contact_of(rest);
    const std::vector<double> masses = rest.masses();
    std::vector<Vec3> x = Banks(0.15).mesh.vertices;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        x[k].z += 0.1 * hash_uniform(2, k);
    }
    const Evaluated at = evaluate(contact, x);
    std::vector<Vec3> direction(x.size());
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        direction[k] = {hash_uniform(3, k) - 0.5, hash_uniform(4, k) - 0.5, hash_uniform(6, k) - 0.5};
    }
    double eigenvalue = 0.0;
    for (int round = 0; round < 200; ++round)
    {
        double length = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            length += masses[k] * squared_norm(direction[k]);
        }
        std::vector<Vec3> moved = x;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            direction[k] = direction[k] / std::sqrt(length);
            moved[k] += 1e-7 * direction[k];
        }
        const Evaluated then = evaluate(contact, moved);
        eigenvalue = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            const Vec3 pull = (at.forces[k] - then.forces[k]) / 1e-7;
            eigenvalue += dot(direction[k], pull);
            direction[k] = pull / masses[k];
        }
    }
    EXPECT_GT(eigenvalue, 0.0);
    EXPECT_GE(at.response.largest_rate * at.response.largest_rate, eigenvalue);
    EXPECT_LE(at.response.largest_rate * at.response.largest_rate, 6.0 * eigenvalue); // and not absurdly large
}

TEST(SurfaceContact, ForcesAreMinusTheGradientOfTheEnergy)
{
    contact::SurfaceContact contact = contact_of(Banks(2.0));
    std::vector<Vec3> x = Banks(0.2).mesh.vertices;
    for (std::size_t k = 0; k < x.size(); ++k) // rough, so that no two pairs are equally close
    {
        x[k] +=
            Vec3{0.05 * hash_uniform(2, 3 * k), 0.05 * hash_uniform(2, 3 * k + 1), 0.1 * hash_uniform(2, 3 * k + 2)};
    }
    const Evaluated at = evaluate(contact, x);
    ASSERT_GT(at.response.active, 30);
    double largest = 0.0;
    for (const Vec3& f : at.forces)
    {
        largest = std::max(largest, norm(f));
    }
    const double h = 1e-6;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const double start = x[i][axis];
            x[i][axis] = start + h;
            const double above = evaluate(contact, x).energy;
            x[i][axis] = start - h;
            const double below = evaluate(contact, x).energy;
            x[i][axis] = start;
            // Differences of second order; h² times third derivatives of order f / room².
            EXPECT_NEAR(at.forces[i][axis], -(above - below) / (2.0 * h), 1e-6 * largest) << i << " axis " << axis;
        }
    }
}

TEST(SurfaceContact, TheEnergyIsContinuousWhereAnotherPairBecomesTheClosest)
{
    // A rough bank slides over another. The energy changes by no more than the forces on the way say.
    contact::SurfaceContact contact = contact_of(Banks(2.0));
    std::vector<Vec3> x = Banks(0.12).mesh.vertices;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        x[k].z += 0.06 * hash_uniform(5, k);
    }
    const double step = 1e-4;
    const auto slope = [&](const Evaluated& e) { return -sum(std::span(e.forces).subspan(Banks(2.0).lower_count)).x; };
    Evaluated before = evaluate(contact, x);
    double steepest = 0.0;
    for (int k = 0; k < 3000; ++k)
    {
        for (std::size_t i = Banks(2.0).lower_count; i < x.size(); ++i)
        {
            x[i].x += step;
        }
        const Evaluated now = evaluate(contact, x);
        steepest = std::max({steepest, std::abs(slope(before)), std::abs(slope(now))});
        EXPECT_LE(std::abs(now.energy - before.energy), 1.1 * step * steepest) << k;
        before = now;
    }
    EXPECT_GT(steepest, 0.0);
}

TEST(SurfaceContact, RestCloserThanTheActivationDistanceIsFreeOfForce)
{
    const Banks rest(0.1);
    contact::SurfaceContact contact = contact_of(rest);
    EXPECT_EQ(evaluate(contact, rest.mesh.vertices).response.active, 0);
    EXPECT_EQ(evaluate(contact, Banks(0.15).mesh.vertices).response.active, 0);
    const Evaluated pressed = evaluate(contact, Banks(0.08).mesh.vertices);
    EXPECT_GT(pressed.response.active, 0);
    EXPECT_GT(sum(std::span(pressed.forces).subspan(rest.lower_count)).z, 0.0);
}

TEST(SurfaceContact, OnlyTheClosestTrianglePushes)
{
    // A tip at the origin, a plate 0.1 above it and another 0.244 beside it; their edges are far.
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    const std::vector<Vec3> x{{0, 0, 0},       {5, -0.5, -5},      {5, 0.5, -5},      {-0.36, -9, 0.1}, {9, 0, 0.1},
                              {-0.36, 9, 0.1}, {-0.487, -9, 0.27}, {-0.487, 9, 0.27}, {4.96, 0, -7.52}};
    std::vector<Vec3> rest = x;
    for (std::size_t k = 0; k < 3; ++k)
    {
        rest[3 + k].z += 3.0;
        rest[6 + k].x -= 3.0;
    }
    contact::SurfaceContact contact(triangles, rest, std::vector<double>(9, 1.0), 1.0, frequency,
                                    {true, 0.3, stiffness});
    const std::vector<double> reach(x.size());
    contact::Candidates found;
    contact::SurfaceParts(triangles, x).find_candidates(x, 0.3, reach, {}, found);
    EXPECT_EQ(std::ranges::count(found.vertex_triangle, 0, &contact::VertexTriangle::vertex), 2);
    const Evaluated result = evaluate(contact, x);
    EXPECT_LT(result.forces[0].z, 0.0);
    EXPECT_NEAR(result.forces[0].x, 0.0, 1e-12); // of a force of order one
}

TEST(SurfaceContact, FoldedNeighboursRepel)
{
    // Two triangles on a common edge, hinged from flat to nearly shut.
    const std::vector<Triangle> triangles{{0, 1, 2}, {1, 0, 3}};
    const auto hinge = [](double angle) {
        return std::vector<Vec3>{
            {0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, {0.5, 0.8 * std::cos(angle), 0.8 * std::sin(angle)}};
    };
    contact::SurfaceContact contact(triangles, hinge(3.1), std::vector<double>(4, 1.0), 1.0, frequency,
                                    {true, 0.3, stiffness});
    EXPECT_EQ(evaluate(contact, hinge(0.5)).response.active, 0);
    const Evaluated shut = evaluate(contact, hinge(0.2));
    EXPECT_GT(shut.response.active, 0);
    EXPECT_GT(shut.forces[3].z, 0.0);
    EXPECT_LT(shut.forces[2].z, 0.0);
    EXPECT_LT(norm(sum(shut.forces)), 1e-13 * norm(shut.forces[3]));
}

TEST(SurfaceContact, HistoryLeavesNoTrace)
{
    const Banks rest(2.0);
    const auto crumpled = [&](double gap, std::uint64_t seed, double amplitude)
    {
        std::vector<Vec3> x = Banks(gap).mesh.vertices;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            x[k] += amplitude *
                    Vec3{hash_uniform(seed, 3 * k), hash_uniform(seed, 3 * k + 1), hash_uniform(seed, 3 * k + 2)};
        }
        return x;
    };
    const std::vector<Vec3> now = crumpled(0.2, 4, 0.1);
    contact::SurfaceContact fresh = contact_of(rest);
    const Evaluated expected = evaluate(fresh, now);
    ASSERT_GT(expected.response.active, 5);
    // Before: within the skin of now, just beyond it, and far off.
    for (const double before : {0.21, 0.4, 1.2})
    {
        contact::SurfaceContact used = contact_of(rest);
        evaluate(used, crumpled(before, 4, 0.1));
        evaluate(used, crumpled(before - 0.005, 4, 0.1));
        const Evaluated again = evaluate(used, now);
        EXPECT_EQ(again.forces, expected.forces);
        EXPECT_EQ(again.response.largest_rate, expected.response.largest_rate);
        EXPECT_EQ(again.energy, expected.energy);
    }
}

TEST(SurfaceContact, NoPairIsMissedWhereSomeVerticesWander)
{
    const Banks rest(2.0);
    contact::SurfaceContact used = contact_of(rest);
    std::vector<Vec3> x = Banks(0.25).mesh.vertices;
    std::vector<Vec3> way(x.size());
    int touched = 0;
    for (std::uint64_t step = 0; step < 400; ++step)
    {
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            // A few go fast, each for a while, the others creep; all are held to some 0.2 around where they began.
            const double pace = hash_uniform(k, step / 20) < 0.1 ? 0.03 : 0.002;
            const Vec3 push{hash_uniform(3 * k, step) - 0.5, hash_uniform(3 * k + 1, step) - 0.5,
                            hash_uniform(3 * k + 2, step) - 0.5};
            const Vec3 next = way[k] + pace * push;
            way[k] = norm(next) < 0.2 ? next : way[k];
        }
        std::vector<Vec3> now = x;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            now[k] += way[k];
        }
        const Evaluated kept = evaluate(used, now);
        if (step % 4 == 0)
        {
            contact::SurfaceContact fresh = contact_of(rest);
            const Evaluated expected = evaluate(fresh, now);
            ASSERT_EQ(kept.forces, expected.forces) << step;
            touched += expected.response.active > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(touched, 90);
}

} // namespace
} // namespace corticle
