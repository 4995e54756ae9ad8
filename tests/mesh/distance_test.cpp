// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/simd.hpp"
#include "corticle/mesh/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace corticle
{
namespace
{

constexpr double rounding = 1e-12;

Vec3 random_point(std::mt19937& random)
{
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    const double x = place(random);
    const double y = place(random);
    return {x, y, place(random)};
}

/// Of all points of the body that `corners` span, `point` is the closest to `to`: no corner lies on the near side of
/// the plane through it. Holds for no other point.
void expect_closest(const Vec3& point, const Vec3& to, const std::vector<Vec3>& corners)
{
    for (const Vec3& corner : corners)
    {
        EXPECT_LE(dot(to - point, corner - point), rounding);
    }
}

TEST(ClosestOnTriangle, IsClosestFromFacesEdgesAndCorners)
{
    std::mt19937 random(1);
    std::array<int, 4> zeros{}; // how often so many weights were zero: face, edge, corner
    for (int trial = 0; trial < 3000; ++trial)
    {
        const Vec3 p = 2.0 * random_point(random);
        const std::vector<Vec3> corner{random_point(random), random_point(random), random_point(random)};
        const auto w = closest_on_triangle(p, corner[0], corner[1], corner[2]);
        EXPECT_NEAR(w[0] + w[1] + w[2], 1.0, rounding);
        EXPECT_GE(std::ranges::min(w), -rounding);
        expect_closest(w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2], p, corner);
        ++zeros[static_cast<std::size_t>(std::ranges::count_if(w, [](double x) { return std::abs(x) < rounding; }))];
    }
    EXPECT_GT(std::min({zeros[0], zeros[1], zeros[2]}), 100);
}

TEST(ClosestOnTriangle, OfACornerOrOfAPointOnAnEdgeIsThePointItself)
{
    const Vec3 a{0, 0, 0};
    const Vec3 b{1, 0, 0};
    const Vec3 c{0, 1, 0};
    EXPECT_EQ(closest_on_triangle(a, a, b, c), (std::array{1.0, 0.0, 0.0}));
    EXPECT_EQ(closest_on_triangle(b, a, b, c), (std::array{0.0, 1.0, 0.0}));
    EXPECT_EQ(closest_on_triangle(c, a, b, c), (std::array{0.0, 0.0, 1.0}));
    EXPECT_EQ(closest_on_triangle(0.5 * (a + b), a, b, c), (std::array{0.5, 0.5, 0.0}));
    EXPECT_EQ(closest_on_triangle(0.5 * (b + c), a, b, c), (std::array{0.0, 0.5, 0.5}));
    EXPECT_EQ(closest_on_triangle(0.5 * (c + a), a, b, c), (std::array{0.5, 0.0, 0.5}));
}

void expect_closest_segments(const std::vector<Vec3>& first, const std::vector<Vec3>& second)
{
    const auto [s, t] = closest_of_segments(first[0], first[1], second[0], second[1]);
    EXPECT_TRUE(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) << s << " " << t;
    const Vec3 on_first = first[0] + s * (first[1] - first[0]);
    const Vec3 on_second = second[0] + t * (second[1] - second[0]);
    expect_closest(on_first, on_second, first);
    expect_closest(on_second, on_first, second);
}

TEST(ClosestOfSegments, IsClosestOnBoth)
{
    std::mt19937 random(2);
    for (int trial = 0; trial < 3000; ++trial)
    {
        expect_closest_segments({random_point(random), random_point(random)},
                                {random_point(random), random_point(random)});
    }
}

TEST(ClosestOfSegments, OfParallelOnesAndOfPoints)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 100; ++trial)
    {
        const Vec3 a = random_point(random);
        const Vec3 b = random_point(random);
        const Vec3 aside = random_point(random);
        expect_closest_segments({a, b}, {a + aside, b + aside});
        expect_closest_segments({a, a}, {b, aside});
        expect_closest_segments({b, aside}, {a, a});
        expect_closest_segments({a, a}, {b, b});
        expect_closest_segments({a, b}, {b, a});
    }
}

/// What eight lanes give is what each gives alone.
TEST(ClosestPoints, AreTheSameInLanes)
{
    std::mt19937 random(4);
    for (int trial = 0; trial < 200; ++trial)
    {
        std::array<std::array<Vec3, 4>, wide_lanes> points;
        BasicVec3<WideLanes> wide[4];
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            for (std::size_t c = 0; c < 4; ++c)
            {
                points[lane][c] = random_point(random);
                at_lane(wide[c].x, lane) = points[lane][c].x;
                at_lane(wide[c].y, lane) = points[lane][c].y;
                at_lane(wide[c].z, lane) = points[lane][c].z;
            }
        }
        auto on_triangle = closest_on_triangle(wide[0], wide[1], wide[2], wide[3]);
        auto of_segments = closest_of_segments(wide[0], wide[1], wide[2], wide[3]);
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            const auto& [p, a, b, c] = points[lane];
            const auto weights = closest_on_triangle(p, a, b, c);
            const auto places = closest_of_segments(p, a, b, c);
            for (std::size_t k = 0; k < 3; ++k)
            {
                EXPECT_NEAR(at_lane(on_triangle[k], lane), weights[k], rounding);
            }
            for (std::size_t k = 0; k < 2; ++k)
            {
                EXPECT_NEAR(at_lane(of_segments[k], lane), places[k], rounding);
            }
        }
    }
}

} // namespace
} // namespace corticle
