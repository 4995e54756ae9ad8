// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/surface_contact.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/dynamics/integrator.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "geometry/simple_surfaces.hpp"
#include "mechanics/contact/banks.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Vertices without any stiffness of their own, held apart by contact alone.
struct Loose
{
    TriangleMesh mesh;
    std::vector<double> masses;
    contact::SurfaceContact contact;
    dynamics::Motion motion;
    std::int64_t active = 0;
    std::int64_t limited = 0;

    Loose(const TriangleMesh& surface, double spacing)
        : mesh(surface), masses(surface.vertices.size(), 1.0),
          contact(mesh.triangles, mesh.vertices, masses, spacing, 1.0, {}), motion{mesh.vertices,
                                                                                   std::vector<Vec3>(masses.size()),
                                                                                   std::vector<Vec3>(masses.size())}
    {
    }

    /// One step of length dt under loads; the contact sees to it that nothing crosses.
    void step(double dt, std::span<const Vec3> loads)
    {
        motion.force.assign(loads.begin(), loads.end());
        active += contact.evaluate(motion.x, motion.force).active;
        dynamics::Motion next = motion;
        const double longest = dynamics::advance(motion, masses, dt, {}, next).longest;
        if (contact.stays_apart({next.v, dt, longest}))
        {
            motion = std::move(next);
            return;
        }
        std::vector<Vec3> displacements = next.v;
        for (Vec3& u : displacements)
        {
            u *= dt;
        }
        limited += std::ssize(contact.hold_apart(displacements));
        for (std::size_t k = 0; k < displacements.size(); ++k)
        {
            next.v[k] = displacements[k] / dt;
            next.x[k] = motion.x[k] + displacements[k];
        }
        motion = std::move(next);
    }
    bool crosses() const { return !geometry::self_intersections({motion.x, mesh.triangles}).empty(); }
};

/// Two spheres of the same size, shot at each other in steps far too long.
TEST(TravelLimit, SurfacesNeverCrossHoweverFastTheyMove)
{
    const TriangleMesh ball = geometry::make_ellipsoid({2, 2, 2}, 0.7);
    TriangleMesh left = ball;
    TriangleMesh right = ball;
    for (std::size_t k = 0; k < ball.vertices.size(); ++k)
    {
        left.vertices[k].x -= 2.4;
        right.vertices[k] += Vec3{2.4, 0.3, 0.2};
    }
    const std::size_t half = ball.vertices.size();
    Loose both(test::together(left, right), 0.7);
    const std::vector<Vec3> no_load(2 * half);
    for (std::uint64_t step = 0; step < 500; ++step)
    {
        for (std::size_t k = 0; k < 2 * half; ++k) // up to the length of a ball in each step
        {
            both.motion.v[k] = Vec3{k < half ? 20.0 : -20.0, 0, 0} + 20.0 * test::random_vector(step, k);
        }
        both.step(0.1, no_load);
        ASSERT_FALSE(both.crosses()) << "step " << step;
        const geometry::SurfaceTree other(std::span(both.motion.x).subspan(half), ball.triangles);
        for (std::size_t k = 0; k < half; ++k)
        {
            ASSERT_EQ(other.winding_number(both.motion.x[k]), 0) << "vertex " << k << " step " << step;
        }
    }
    EXPECT_GT(both.active, 1000);
    EXPECT_GT(both.limited, 1000);
}

/// Two rough plates, pressed together for 10,000 steps by a constant load per vertex, in units of what the barrier
/// holds at half its room.
class PressedPlates : public testing::TestWithParam<double>
{
};

TEST_P(PressedPlates, NeverCross)
{
    set_thread_count(1); // a hundred vertices are not worth a second
    const TriangleMesh lower = test::sheet(6, 0.0, 0.0, 0.0);
    const std::size_t half = lower.vertices.size();
    TriangleMesh mesh = test::together(lower, test::sheet(6, 0.5, 0.31, 0.27));
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
    {
        mesh.vertices[k] += 0.1 * test::random_vector(1, k);
    }
    Loose plates(mesh, 1.0);
    const contact::ContactOptions options;
    const double hold = options.stiffness * options.distance; // the spacing is 1
    std::vector<Vec3> loads(2 * half);
    for (std::size_t k = 0; k < 2 * half; ++k)
    {
        loads[k].z = (k < half ? 1.0 : -1.0) * GetParam() * hold;
    }
    for (int step = 0; step < 10000; ++step)
    {
        plates.step(1.0, loads);
        if (step % 20 == 0 || step < 200)
        {
            ASSERT_FALSE(plates.crosses()) << "step " << step;
        }
    }
    EXPECT_GT(plates.active, 10000);
}

INSTANTIATE_TEST_SUITE_P(Loads, PressedPlates, testing::Values(0.5, 1.0, 2.0, 4.0, 20.0, 100.0));

TEST(TravelLimit, BanksThatMoveTogetherLoseNothing)
{
    for (const double gap : {1e-1, 1e-2, 1e-4, 1e-6})
    {
        Loose banks(test::Banks(gap).mesh, 1.0);
        const std::vector<Vec3> no_load(banks.masses.size());
        const std::vector<Vec3> start = banks.motion.x;
        const Vec3 velocity{0.02, 0.03, -0.5};
        std::ranges::fill(banks.motion.v, velocity);
        for (int step = 0; step < 100; ++step)
        {
            banks.step(1.0, no_load);
        }
        for (std::size_t k = 0; k < start.size(); ++k)
        {
            // Of a way of 50: round-off in the distance of banks at their gap is a force.
            EXPECT_LT(norm(banks.motion.x[k] - start[k] - 100.0 * velocity), 1e-6) << gap;
        }
    }
}

/// Whether the limit leaves a step alone in which both banks move at right angles to themselves, by these ways.
bool stays_apart(Loose& banks, double of_lower, double of_upper)
{
    std::vector<Vec3> velocity(banks.masses.size(), Vec3{0, 0, of_upper});
    std::fill_n(velocity.begin(), test::Banks(1.0).lower_count, Vec3{0, 0, of_lower});
    return banks.contact.stays_apart({velocity, 1.0, std::max(std::abs(of_lower), std::abs(of_upper))});
}

TEST(TravelLimit, LeavesAStepAloneInWhichNothingComesTooClose)
{
    Loose banks(test::Banks(2.0).mesh, 1.0);
    std::vector<Vec3> forces(banks.masses.size());
    banks.contact.evaluate(banks.motion.x, forces);
    EXPECT_TRUE(stays_apart(banks, 0.1, -0.1));
    EXPECT_FALSE(stays_apart(banks, 0.2, -0.2)); // 0.4 of 0.3 at most
    banks.contact.evaluate(test::Banks(0.1).mesh.vertices, forces);
    EXPECT_TRUE(stays_apart(banks, 0.03, -0.03)); // 0.8 of 0.1 - 0.006, for both
    EXPECT_FALSE(stays_apart(banks, 0.04, -0.04));
    EXPECT_FALSE(stays_apart(banks, 0.08, 0.0));
    EXPECT_TRUE(stays_apart(banks, 0.08, 0.08));
    EXPECT_TRUE(stays_apart(banks, -0.08, 0.08));
    EXPECT_FALSE(stays_apart(banks, std::nan(""), 0.0));
}

TEST(TravelLimit, KeepsTheMomentumOfWhatItJoins)
{
    Loose banks(test::Banks(0.01).mesh, 1.0);
    std::vector<Vec3> displacements(banks.masses.size());
    for (std::size_t k = 0; k < displacements.size(); ++k)
    {
        displacements[k] = 0.05 * test::random_vector(7, k);
    }
    std::vector<Vec3> forces(displacements.size());
    banks.contact.evaluate(banks.motion.x, forces);
    Vec3 before;
    Vec3 after;
    for (const Vec3& u : displacements)
    {
        before += u;
    }
    EXPECT_GT(std::ssize(banks.contact.hold_apart(displacements)), 10);
    for (const Vec3& u : displacements)
    {
        after += u;
    }
    EXPECT_LT(norm(after - before), 1e-14);
}

} // namespace
} // namespace corticle
