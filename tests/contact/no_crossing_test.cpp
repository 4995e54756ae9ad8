// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/contact/surface_contact.hpp"

#include "corticle/dynamics/integrator.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "geometry/simple_surfaces.hpp"
#include "tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Two spheres of the same size without any stiffness of their own, shot at each other in steps far too long.
TEST(TravelLimit, SurfacesNeverCrossHoweverFastTheyMove)
{
    const TriangleMesh ball = make_ellipsoid({2, 2, 2}, 0.7);
    TriangleMesh left = ball;
    TriangleMesh right = ball;
    for (std::size_t k = 0; k < ball.vertices.size(); ++k)
    {
        left.vertices[k].x -= 2.4;
        right.vertices[k] += Vec3{2.4, 0.3, 0.2};
    }
    const TriangleMesh both = test::together(left, right);
    const std::size_t half = ball.vertices.size();
    const std::vector<double> masses(2 * half, 1.0);
    SurfaceContact contact(both.triangles, both.vertices, masses, 0.7, {});
    Motion motion{both.vertices, std::vector<Vec3>(2 * half), std::vector<Vec3>(2 * half)};
    Motion next = motion;
    const double dt = 0.1;
    // Each step leaves at least a fifth of the smallest distance; at fifty it is near 1e-8, still far above round-off.
    constexpr std::uint64_t steps = 50;
    std::int64_t limited = 0;
    std::int64_t active = 0;
    for (std::uint64_t step = 0; step < steps; ++step)
    {
        for (std::size_t k = 0; k < 2 * half; ++k) // up to the length of a ball in each step
        {
            motion.v[k] = Vec3{k < half ? 20.0 : -20.0, 0, 0} + 20.0 * test::random_vector(step, k);
        }
        std::fill(motion.force.begin(), motion.force.end(), Vec3{});
        active += contact.evaluate(motion.x, motion.v, dt, motion.force).active;
        limited += advance(motion, masses, contact.travel_limit(), dt, 0.0, next).limited;
        std::swap(motion, next);
        ASSERT_TRUE(self_intersections({motion.x, both.triangles}).empty()) << "step " << step;
        const SurfaceTree other(std::span(motion.x).subspan(half), ball.triangles);
        for (std::size_t k = 0; k < half; ++k)
        {
            ASSERT_EQ(other.winding_number(motion.x[k]), 0) << "vertex " << k << " step " << step;
        }
    }
    EXPECT_GT(active, 1000);
    EXPECT_GT(limited, 1000);
}

} // namespace
} // namespace corticle
