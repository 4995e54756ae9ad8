// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/drawn_boundary.hpp"

#include "corticle/geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace corticle::view
{

namespace
{

constexpr double scatter = 0.3;

/// A ball of radius 10 whose boundary lies 2.5 below its surface, scattered; without cortex where z < -5.
formats::SurfaceFile scattered_ball()
{
    formats::SurfaceFile file;
    file.mesh = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 0.9);
    std::vector<double> boundary;
    for (std::size_t v = 0; v < file.mesh.vertices.size(); ++v)
    {
        const Vec3& x = file.mesh.vertices[v];
        const double depth = x.z < -5.0 ? 0.0 : 2.5 + scatter * std::sin(1000.0 * static_cast<double>(v));
        const Vec3 inner = (1.0 - depth / norm(x)) * x;
        boundary.insert(boundary.end(), {inner.x, inner.y, inner.z});
    }
    file.fields.emplace_back("cortex_boundary", boundary);
    return file;
}

} // namespace

TEST(DrawnBoundary, IsEvenAndKeepsItsSize)
{
    const formats::SurfaceFile file = scattered_ball();
    const std::vector<Vec3> boundary = drawn_boundary(file);
    ASSERT_EQ(boundary.size(), file.mesh.vertices.size());
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t v = 0; v < boundary.size(); ++v)
    {
        if (file.mesh.vertices[v].z < -5.0)
        {
            EXPECT_EQ(boundary[v], file.mesh.vertices[v]);
        }
        else if (file.mesh.vertices[v].z > -2.0) // away from the edge of the cortex
        {
            const double depth = 10.0 - norm(boundary[v]);
            sum += depth;
            squares += depth * depth;
            count += 1.0;
        }
    }
    const double mean = sum / count;
    EXPECT_NEAR(mean, 2.5, 0.05); // 2 %; the filter hardly shrinks
    // Given: scatter / sqrt(2), the root mean square of a sine. What changes from vertex to vertex goes, longer waves
    // stay.
    EXPECT_LT(std::sqrt(squares / count - mean * mean), 0.4 * scatter / std::sqrt(2.0));
}

TEST(DrawnBoundary, IsEmptyWithoutTheArray)
{
    formats::SurfaceFile file = scattered_ball();
    file.fields[0].first = "theta";
    EXPECT_TRUE(drawn_boundary(file).empty());
}

} // namespace corticle::view
