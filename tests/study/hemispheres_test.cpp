// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/hemispheres.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/gather.hpp"
#include "corticle/geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace corticle
{

namespace
{

/// Two balls side by side; their vertices alternate.
TriangleMesh two_balls(double distance)
{
    const TriangleMesh ball = geometry::make_ellipsoid({2.0, 3.0, 2.0}, 0.6);
    TriangleMesh both;
    for (const Vec3& point : ball.vertices)
    {
        both.vertices.push_back(point - Vec3{distance, 0, 0});
        both.vertices.push_back(point + Vec3{distance, 0, 0});
    }
    for (const Triangle& t : ball.triangles)
    {
        both.triangles.push_back({2 * t[0], 2 * t[1], 2 * t[2]});
        both.triangles.push_back({2 * t[0] + 1, 2 * t[1] + 1, 2 * t[2] + 1});
    }
    return both;
}

} // namespace

TEST(Hemispheres, SeparateOnesComeApartWhole)
{
    const TriangleMesh both = two_balls(2.5);
    ASSERT_TRUE(study::has_separate_hemispheres(both));
    const auto parts = study::hemispheres(both, false);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].structure, "CortexLeft");
    EXPECT_EQ(parts[1].letter, "R");
    double volume = 0.0;
    for (const study::SurfacePart& part : parts)
    {
        EXPECT_EQ(2 * part.triangles.size(), both.triangles.size());
        volume += enclosed_volume(gather<Vec3>(both.vertices, part.kept), part.triangles);
    }
    EXPECT_NEAR(volume, enclosed_volume(both.vertices, both.triangles), 1e-9);
    const auto left = gather<Vec3>(both.vertices, parts[0].kept);
    EXPECT_TRUE(std::ranges::all_of(left, [](const Vec3& point) { return point.x < 0.0; }));
}

TEST(Hemispheres, ConnectedOnesAreCutBetweenTriangles)
{
    const TriangleMesh ball = geometry::make_ellipsoid({2.0, 3.0, 2.0}, 0.4);
    EXPECT_FALSE(study::has_separate_hemispheres(ball));
    const auto parts = study::hemispheres(ball, true);
    EXPECT_EQ(parts[0].triangles.size() + parts[1].triangles.size(), ball.triangles.size());
    for (std::size_t side = 0; side < 2; ++side)
    {
        EXPECT_NEAR(static_cast<double>(parts[side].triangles.size()), 0.5 * static_cast<double>(ball.triangles.size()),
                    0.1 * static_cast<double>(ball.triangles.size()));
        for (const Triangle& triangle : parts[side].triangles)
        {
            double x = 0.0;
            for (const std::int32_t v : triangle)
            {
                x += ball.vertices[static_cast<std::size_t>(parts[side].kept[static_cast<std::size_t>(v)])].x;
            }
            EXPECT_EQ(x / 3.0 < bounding_box(ball.vertices).center().x, side == 0);
        }
    }
}

TEST(Hemispheres, OverlappingOnesAreNotSeparate)
{
    EXPECT_FALSE(study::has_separate_hemispheres(two_balls(1.5))); // each reaches across the middle
}

} // namespace corticle
