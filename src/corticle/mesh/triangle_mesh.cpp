// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/triangle_mesh.hpp"

#include <cmath>

namespace corticle
{

double surface_area(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    double twice_area = 0.0;
    for (const Triangle& t : triangles)
    {
        twice_area += norm(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
    }
    return 0.5 * twice_area;
}

double enclosed_volume(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    if (triangles.empty())
    {
        return 0.0;
    }
    // Tetrahedra with a vertex of the surface as apex: no cancellation for a surface far from the origin.
    const Vec3 apex = vertices[triangles[0][0]];
    double six_volumes = 0.0;
    for (const Triangle& t : triangles)
    {
        six_volumes += dot(vertices[t[0]] - apex, cross(vertices[t[1]] - apex, vertices[t[2]] - apex));
    }
    return six_volumes / 6.0;
}

double sphere_index(double area, double volume)
{
    return area / (std::cbrt(std::numbers::pi) * std::pow(6.0 * volume, 2.0 / 3.0));
}

std::vector<Vec3> vertex_normals(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    std::vector<Vec3> normals(vertices.size());
    for (const Triangle& t : triangles)
    {
        const Vec3 normal = normalized(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
        for (int corner = 0; corner < 3; ++corner)
        {
            const Vec3 e1 = vertices[t[(corner + 1) % 3]] - vertices[t[corner]];
            const Vec3 e2 = vertices[t[(corner + 2) % 3]] - vertices[t[corner]];
            const double angle = std::atan2(norm(cross(e1, e2)), dot(e1, e2));
            normals[t[corner]] += angle * normal;
        }
    }
    for (Vec3& normal : normals)
    {
        normal = normalized(normal);
    }
    return normals;
}

std::vector<double> vertex_areas(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    std::vector<double> areas(vertices.size(), 0.0);
    for (const Triangle& t : triangles)
    {
        const double area = 0.5 * norm(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
        for (const std::int32_t vertex : t)
        {
            areas[vertex] += area / 3.0;
        }
    }
    return areas;
}

} // namespace corticle
