// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/triangle_tests.hpp"

#include <algorithm>
#include <utility>

namespace corticle::geometry
{

namespace
{

/// Closest point of the edge opposite to corner k.
SurfacePoint closest_point_of_edge(const TriangleMesh& mesh, std::int32_t triangle, int k, const Vec3& point)
{
    const Triangle& t = mesh.triangles[triangle];
    int first = (k + 1) % 3;
    int second = (k + 2) % 3;
    if (t[first] > t[second])
    {
        std::swap(first, second);
    }
    const Vec3& a = mesh.vertices[t[first]];
    const Vec3 ab = mesh.vertices[t[second]] - a;
    const double length2 = squared_norm(ab);
    const double s = length2 > 0.0 ? std::clamp(dot(point - a, ab) / length2, 0.0, 1.0) : 0.0;
    SurfacePoint result;
    result.triangle = triangle;
    result.position = s == 1.0 ? mesh.vertices[t[second]] : a + s * ab;
    result.barycentric[first] = 1.0 - s;
    result.barycentric[second] = s;
    result.squared_distance = squared_norm(point - result.position);
    return result;
}

/// Six times the volume of (0, direction, a - point, b - point); its sign says on which side of the edge the ray
/// passes. Exactly antisymmetric in the two vertices.
double side_of_edge(const TriangleMesh& mesh, std::int32_t a, std::int32_t b, const Vec3& point, const Vec3& direction)
{
    const bool swap = a > b;
    const Vec3 pa = mesh.vertices[swap ? b : a] - point;
    const Vec3 pb = mesh.vertices[swap ? a : b] - point;
    const double side = dot(direction, cross(pa, pb));
    return swap ? -side : side;
}

} // namespace

SurfacePoint closest_point_of_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& point)
{
    const Triangle& t = mesh.triangles[triangle];
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3& b = mesh.vertices[t[1]];
    const Vec3& c = mesh.vertices[t[2]];
    const Vec3 normal = cross(b - a, c - a);
    const double normal2 = squared_norm(normal);
    // Barycentric coordinates of the projection, times |normal|².
    const double wa = dot(cross(b - point, c - point), normal);
    const double wb = dot(cross(c - point, a - point), normal);
    const double wc = dot(cross(a - point, b - point), normal);
    if (normal2 > 0.0 && wa > 0.0 && wb > 0.0 && wc > 0.0)
    {
        const double sum = wa + wb + wc;
        SurfacePoint result;
        result.triangle = triangle;
        result.barycentric = {wa / sum, wb / sum, wc / sum};
        const double height = dot(point - a, normal);
        result.position = point - (height / normal2) * normal;
        result.squared_distance = height * height / normal2;
        return result;
    }
    SurfacePoint best;
    for (int k = 0; k < 3; ++k)
    {
        // The projection lies beyond at least one edge; where it lies within the others the closest point is not there.
        const double weight = k == 0 ? wa : (k == 1 ? wb : wc);
        if (weight > 0.0 && normal2 > 0.0)
        {
            continue;
        }
        const SurfacePoint candidate = closest_point_of_edge(mesh, triangle, k, point);
        if (best.triangle < 0 || candidate.squared_distance < best.squared_distance)
        {
            best = candidate;
        }
    }
    return best.triangle >= 0 ? best : closest_point_of_edge(mesh, triangle, 0, point);
}

bool segment_meets_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& a, const Vec3& b)
{
    const Triangle& t = mesh.triangles[triangle];
    const Vec3 direction = b - a;
    const double s0 = side_of_edge(mesh, t[1], t[2], a, direction);
    const double s1 = side_of_edge(mesh, t[2], t[0], a, direction);
    const double s2 = side_of_edge(mesh, t[0], t[1], a, direction);
    const bool front = s0 >= 0.0 && s1 >= 0.0 && s2 >= 0.0;
    const bool back = s0 <= 0.0 && s1 <= 0.0 && s2 <= 0.0;
    if (front == back) // missed, or in the plane of the triangle
    {
        return false;
    }
    const Vec3& v = mesh.vertices[t[0]];
    const Vec3 normal = cross(mesh.vertices[t[1]] - v, mesh.vertices[t[2]] - v);
    const double height_a = dot(a - v, normal);
    const double height_b = dot(b - v, normal);
    return (height_a <= 0.0 && height_b >= 0.0) || (height_a >= 0.0 && height_b <= 0.0);
}

RayHit ray_hit(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& point, const Vec3& direction)
{
    const Triangle& t = mesh.triangles[triangle];
    const double s0 = side_of_edge(mesh, t[1], t[2], point, direction);
    const double s1 = side_of_edge(mesh, t[2], t[0], point, direction);
    const double s2 = side_of_edge(mesh, t[0], t[1], point, direction);
    const bool outward = s0 >= 0.0 && s1 >= 0.0 && s2 >= 0.0;
    const bool inward = s0 <= 0.0 && s1 <= 0.0 && s2 <= 0.0;
    if (!outward && !inward)
    {
        return RayHit::none;
    }
    const Vec3& v = mesh.vertices[t[0]];
    const Vec3 normal = cross(mesh.vertices[t[1]] - v, mesh.vertices[t[2]] - v);
    const double height = dot(v - point, normal);
    const double slope = dot(direction, normal);
    if (height * slope < 0.0)
    {
        return RayHit::none; // behind the start
    }
    if (s0 == 0.0 || s1 == 0.0 || s2 == 0.0 || height == 0.0)
    {
        return RayHit::degenerate;
    }
    return outward ? RayHit::outward : RayHit::inward;
}

} // namespace corticle::geometry
