// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/shapes.hpp"

#include <functional>
#include <numbers>

namespace corticle::test
{

/// Place in the half-plane of an axis [mm].
struct ProfilePoint
{
    double r;
    double z;
};

/// The surface that a profile from the lower to the upper pole (both r = 0, not in the list) sweeps about z.
inline TriangleMesh turned(const std::vector<ProfilePoint>& profile, double lower_pole, double upper_pole, int sectors)
{
    TriangleMesh mesh;
    for (const ProfilePoint& p : profile)
    {
        for (int k = 0; k < sectors; ++k)
        {
            const double angle = 2.0 * std::numbers::pi * k / sectors;
            mesh.vertices.push_back({p.r * std::cos(angle), p.r * std::sin(angle), p.z});
        }
    }
    const auto rings = static_cast<std::int32_t>(profile.size());
    const auto pole = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.push_back({0, 0, lower_pole});
    mesh.vertices.push_back({0, 0, upper_pole});
    for (std::int32_t k = 0; k < sectors; ++k)
    {
        const std::int32_t next = (k + 1) % sectors;
        mesh.triangles.push_back({pole, next, k});
        mesh.triangles.push_back({pole + 1, (rings - 1) * sectors + k, (rings - 1) * sectors + next});
        for (std::int32_t ring = 0; ring + 1 < rings; ++ring)
        {
            const std::int32_t at = ring * sectors;
            mesh.triangles.push_back({at + k, at + next, at + sectors + next});
            mesh.triangles.push_back({at + k, at + sectors + next, at + sectors + k});
        }
    }
    return mesh;
}

/// Points along a chain of straight pieces, about `step` apart, without its last corner.
inline std::vector<ProfilePoint> along(const std::vector<ProfilePoint>& corners, double step)
{
    std::vector<ProfilePoint> points;
    for (std::size_t k = 1; k < corners.size(); ++k)
    {
        const ProfilePoint a = corners[k - 1];
        const ProfilePoint b = corners[k];
        const int pieces = std::max(1, static_cast<int>(std::lround(std::hypot(b.r - a.r, b.z - a.z) / step)));
        for (int i = 0; i < pieces; ++i)
        {
            points.push_back({a.r + (b.r - a.r) * i / pieces, a.z + (b.z - a.z) * i / pieces});
        }
    }
    return points;
}

/// An upright cylinder of the given radius over -height/2 … height/2.
inline TriangleMesh cylinder(double radius, double height, double step)
{
    const double half = 0.5 * height;
    const auto profile = along({{step, -half}, {radius, -half}, {radius, half}, {0, half}}, step);
    return turned(profile, -half, half, static_cast<int>(2.0 * std::numbers::pi * radius / step));
}

/// Edge of a mesh of about ten thousand vertices.
inline double edge_for_10000_vertices(double area)
{
    return std::sqrt(area / (10000.0 * 0.5 * std::numbers::sqrt3));
}

/// A sphere of about ten thousand vertices, irregular; made once.
inline TriangleMesh sphere(double radius)
{
    static const TriangleMesh unit =
        geometry::make_ellipsoid({1, 1, 1}, edge_for_10000_vertices(4.0 * std::numbers::pi));
    TriangleMesh mesh = unit;
    for (Vec3& v : mesh.vertices)
    {
        v *= radius;
    }
    return mesh;
}

/// The same with a radius that is a function of the direction.
inline TriangleMesh star(const std::function<double(const Vec3&)>& radius_at)
{
    TriangleMesh mesh = sphere(1.0);
    for (Vec3& v : mesh.vertices)
    {
        const Vec3 direction = normalized(v);
        v = radius_at(direction) * direction;
    }
    return mesh;
}

} // namespace corticle::test
