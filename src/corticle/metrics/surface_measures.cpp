// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface_measures.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/geometry/triangle_tests.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/curved_surface.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace corticle::metrics
{

namespace
{

Vec3 area_vector(const TriangleMesh& mesh, const Triangle& corner)
{
    const Vec3 a = mesh.vertices[static_cast<std::size_t>(corner[0])];
    return cross(mesh.vertices[static_cast<std::size_t>(corner[1])] - a,
                 mesh.vertices[static_cast<std::size_t>(corner[2])] - a);
}

/// Distance from a point of a covered triangle to the nearest part of the surface that faces it [mm]: its own sheet
/// faces the same way and does not count.
double distance_to_pierced(const Vec3& point, const Vec3& normal, const TriangleMesh& mesh)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    {
        if (dot(area_vector(mesh, mesh.triangles[k]), normal) < 0.0)
        {
            const auto triangle = static_cast<std::int32_t>(k);
            smallest = std::min(smallest, geometry::closest_point_of_triangle(mesh, triangle, point).squared_distance);
        }
    }
    return std::sqrt(smallest);
}

} // namespace

SurfaceMeasures measure_surface(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    require_triangles(vertices, triangles);
    SurfaceMeasures m;
    m.area_mm2 = surface_area(vertices, triangles);
    m.volume_mm3 = enclosed_volume(vertices, triangles);
    m.area_per_volume = m.area_mm2 / m.volume_mm3;
    const TriangleMesh hull = geometry::convex_hull(vertices);
    m.hull_area_mm2 = surface_area(hull.vertices, hull.triangles);
    m.gi_hull = m.area_mm2 / m.hull_area_mm2;
    m.gi_sphere = sphere_index(m.area_mm2, m.volume_mm3);
    const CurvedSize curved = curved_size(vertices, triangles);
    m.curved_area_mm2 = curved.area_mm2;
    m.curved_volume_mm3 = curved.volume_mm3;
    m.curved_gi_hull = curved.area_mm2 / m.hull_area_mm2;
    m.curved_gi_sphere = sphere_index(curved.area_mm2, curved.volume_mm3);
    const Vec3 size = bounding_box(vertices).size();
    m.length_mm = size.y;
    m.width_mm = size.x;
    m.height_mm = size.z;
    return m;
}

Overlap measure_overlap(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double probe_distance)
{
    const geometry::SurfaceTree tree(vertices, triangles);
    struct Sum
    {
        double area = 0.0;
        double covered = 0.0;
        double deepest = -1.0;
        Vec3 place;
        void note(double depth, const Vec3& at)
        {
            if (depth > deepest)
            {
                deepest = depth;
                place = at;
            }
        }
    };
    const Sum sum = parallel_reduce(
        std::ssize(triangles), Sum{},
        [&](std::int64_t begin, std::int64_t end)
        {
            Sum part;
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
            {
                const Vec3 a = vertices[static_cast<std::size_t>(triangles[k][0])];
                const Vec3 b = vertices[static_cast<std::size_t>(triangles[k][1])];
                const Vec3 c = vertices[static_cast<std::size_t>(triangles[k][2])];
                const Vec3 normal = cross(b - a, c - a);
                const double area = 0.5 * norm(normal);
                const Vec3 centroid = (a + b + c) / 3.0;
                part.area += area;
                if (tree.winding_number(centroid + probe_distance * normalized(normal)) != 0)
                {
                    part.covered += area;
                    part.note(distance_to_pierced(centroid, normal, tree.mesh()), centroid);
                }
            }
            return part;
        },
        [](Sum& total, const Sum& part)
        {
            total.area += part.area;
            total.covered += part.covered;
            total.note(part.deepest, part.place);
        });
    return {sum.covered / sum.area, std::max(0.0, sum.deepest), sum.place};
}

} // namespace corticle::metrics
