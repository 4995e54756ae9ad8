// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/shapes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/geometry/delaunay_flips.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/geometry/repulsion.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace corticle::geometry
{

namespace
{

using Axes = std::array<double, 3>;

constexpr std::uint64_t shape_seed = 20;
constexpr int relaxation_sweeps = 150;

Vec3 onto_sphere(const Vec3& p, const Axes& a)
{
    return normalized({p.x / a[0], p.y / a[1], p.z / a[2]});
}
Vec3 onto_ellipsoid(const Vec3& unit, const Axes& a)
{
    return {a[0] * unit.x, a[1] * unit.y, a[2] * unit.z};
}

/// Area of the ellipsoid over that of the unit sphere, at a point of the sphere [mm²].
double area_stretch(const Vec3& u, const Axes& a)
{
    return norm(Vec3{a[1] * a[2] * u.x, a[0] * a[2] * u.y, a[0] * a[1] * u.z});
}

/// k-th of `count` points of the golden spiral on the unit sphere.
Vec3 spiral_point(std::int64_t k, std::int64_t count)
{
    const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(count);
    const double turns = static_cast<double>(k) * std::numbers::phi;
    const double angle = 2.0 * std::numbers::pi * (turns - std::floor(turns));
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

double ellipsoid_area(const Axes& a)
{
    constexpr std::int64_t samples = 20000;
    double sum = 0.0;
    for (std::int64_t k = 0; k < samples; ++k)
    {
        sum += area_stretch(spiral_point(k, samples), a);
    }
    return 4.0 * std::numbers::pi * sum / static_cast<double>(samples);
}

/// Points of the ellipsoid, evenly dense, each shaken by about an edge so that nothing of the spiral remains.
std::vector<Vec3> scattered_points(const Axes& a, double edge_length)
{
    const double point_area = 0.5 * std::sqrt(3.0) * edge_length * edge_length; // of a regular triangulation
    const double largest = std::max({a[1] * a[2], a[0] * a[2], a[0] * a[1]});
    const double most = 4.0 * std::numbers::pi * largest / point_area;
    constexpr double too_many = 2e7;
    if (ellipsoid_area(a) < 10.0 * point_area || most > too_many)
    {
        throw InputError("ellipsoid: an edge length of " + std::to_string(edge_length) +
                         " mm does not suit its size; expected about 12 to 20 million vertices");
    }
    std::vector<Vec3> points;
    const auto count = static_cast<std::int64_t>(std::llround(most));
    double credit = 0.5; // keeps the right share of the spiral's points without clumps
    for (std::int64_t k = 0; k < count; ++k)
    {
        const Vec3 unit = spiral_point(k, count);
        credit += area_stretch(unit, a) / largest;
        if (credit < 1.0)
        {
            continue;
        }
        credit -= 1.0;
        const auto counter = static_cast<std::uint64_t>(3 * k);
        const Vec3 shake{hash_uniform(shape_seed, counter) - 0.5, hash_uniform(shape_seed, counter + 1) - 0.5,
                         hash_uniform(shape_seed, counter + 2) - 0.5};
        points.push_back(onto_ellipsoid(onto_sphere(onto_ellipsoid(unit, a) + 2.0 * edge_length * shake, a), a));
    }
    return points;
}

void relax_on_ellipsoid(std::vector<Vec3>& points, const Axes& a, double edge_length)
{
    std::vector<Vec3> moves;
    const std::vector<double> ranges(points.size(), 2.0 * edge_length);
    for (int sweep = 0; sweep < relaxation_sweeps; ++sweep)
    {
        repulsion_moves(points, 0, ranges, 0.12, 0.125, moves);
        parallel_for(
            static_cast<std::int64_t>(points.size()),
            [&](std::int64_t i)
            {
                const Vec3& p = points[i];
                const Vec3 normal = normalized({p.x / (a[0] * a[0]), p.y / (a[1] * a[1]), p.z / (a[2] * a[2])});
                const Vec3 tangential = moves[i] - dot(moves[i], normal) * normal;
                points[i] = onto_ellipsoid(onto_sphere(p + tangential, a), a);
            });
    }
}

} // namespace

TriangleMesh make_ellipsoid(const std::array<double, 3>& semi_axes, double edge_length)
{
    for (const double semi_axis : semi_axes)
    {
        require_positive("ellipsoid: semi-axis [mm]", semi_axis);
    }
    require_positive("ellipsoid: edge length [mm]", edge_length);
    std::vector<Vec3> points = scattered_points(semi_axes, edge_length);
    relax_on_ellipsoid(points, semi_axes, edge_length);
    for (Vec3& p : points)
    {
        p = onto_sphere(p, semi_axes);
    }
    TriangleMesh mesh = convex_hull(points); // on the sphere, where it is the Delaunay triangulation
    for (Vec3& p : mesh.vertices)
    {
        p = onto_ellipsoid(p, semi_axes);
    }
    flip_to_delaunay(mesh);
    const double volume = 4.0 / 3.0 * std::numbers::pi * semi_axes[0] * semi_axes[1] * semi_axes[2];
    const double scale = std::cbrt(volume / enclosed_volume(mesh.vertices, mesh.triangles));
    for (Vec3& p : mesh.vertices)
    {
        p *= scale;
    }
    return mesh;
}

} // namespace corticle::geometry
