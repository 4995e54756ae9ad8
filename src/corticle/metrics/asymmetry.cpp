// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/asymmetry.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/parallel.hpp"

namespace corticle::metrics
{

namespace
{

struct Part
{
    double area = 0.0;
    double volume = 0.0;
};

/// The part of a triangle on the side where `side * height` is positive: its area, and the volume between it and the
/// origin, which lies in the plane, so that the cut face adds nothing.
Part part_of(const std::array<Vec3, 3>& corner, const std::array<double, 3>& height, double side)
{
    std::array<Vec3, 4> polygon;
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
        const int next = (k + 1) % 3;
        if (side * height[k] >= 0.0)
        {
            polygon[count++] = corner[k];
        }
        if (height[k] * height[next] < 0.0)
        {
            polygon[count++] = corner[k] + height[k] / (height[k] - height[next]) * (corner[next] - corner[k]);
        }
    }
    Part part;
    for (int k = 2; k < count; ++k)
    {
        const Vec3 normal = cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
        part.area += 0.5 * norm(normal);
        part.volume += dot(polygon[0], normal) / 6.0;
    }
    return part;
}

double index(double left, double right)
{
    return left + right > 0.0 ? 2.0 * (left - right) / (left + right) : 0.0;
}

} // namespace

Plane mid_sagittal_plane(std::span<const Vec3> points)
{
    return {bounding_box(points).center(), {1, 0, 0}};
}

Asymmetry asymmetry(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const Plane& plane)
{
    struct Halves
    {
        Part left;
        Part right;
    };
    const Vec3 normal = normalized(plane.normal);
    const Halves halves = parallel_reduce(
        std::ssize(triangles), Halves{},
        [&](std::int64_t begin, std::int64_t end)
        {
            Halves sum;
            for (std::int64_t k = begin; k < end; ++k)
            {
                std::array<Vec3, 3> corner;
                std::array<double, 3> height{};
                for (int c = 0; c < 3; ++c)
                {
                    corner[c] = vertices[triangles[k][c]] - plane.point;
                    height[c] = dot(corner[c], normal);
                }
                const Part left = part_of(corner, height, -1.0);
                const Part right = part_of(corner, height, 1.0);
                sum.left = {sum.left.area + left.area, sum.left.volume + left.volume};
                sum.right = {sum.right.area + right.area, sum.right.volume + right.volume};
            }
            return sum;
        },
        [](Halves& all, const Halves& part)
        {
            all.left = {all.left.area + part.left.area, all.left.volume + part.left.volume};
            all.right = {all.right.area + part.right.area, all.right.volume + part.right.volume};
        });
    return {index(halves.left.area, halves.right.area), index(halves.left.volume, halves.right.volume)};
}

} // namespace corticle::metrics
