// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/alpha_wrap.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/cgal_triangles.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/sizes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <limits>

namespace corticle::geometry
{

namespace
{

/// Mean over the wrap of the distance to the input, where it lies within two offsets of it; an edge's middle stands for
/// a third of its triangle [mm].
double mean_distance(const TriangleMesh& wrap, const SurfaceTree& input, double offset)
{
    struct Sums
    {
        double area = 0.0;
        double area_times_distance = 0.0;
    };
    const Sums sums = parallel_reduce(
        static_cast<std::int64_t>(wrap.triangles.size()), Sums{},
        [&](std::int64_t begin, std::int64_t end)
        {
            Sums part;
            for (std::int64_t t = begin; t < end; ++t)
            {
                const Triangle& corners = wrap.triangles[t];
                const Vec3& a = wrap.vertices[corners[0]];
                const Vec3& b = wrap.vertices[corners[1]];
                const Vec3& c = wrap.vertices[corners[2]];
                const double third = norm(cross(b - a, c - a)) / 6.0;
                for (const Vec3& middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
                {
                    const double distance = std::sqrt(input.closest(middle).squared_distance);
                    part.area += distance <= 2.0 * offset ? third : 0.0;
                    part.area_times_distance += distance <= 2.0 * offset ? third * distance : 0.0;
                }
            }
            return part;
        },
        [](Sums& total, const Sums& part)
        {
            total.area += part.area;
            total.area_times_distance += part.area_times_distance;
        });
    return sums.area > 0.0 ? sums.area_times_distance / sums.area : 0.0;
}

/// Every vertex moved by `step` [mm] towards its closest point of the input.
TriangleMesh drawn_back(const TriangleMesh& wrap, const SurfaceTree& input, double step)
{
    TriangleMesh result = wrap;
    parallel_for(static_cast<std::int64_t>(wrap.vertices.size()),
                 [&](std::int64_t i)
                 {
                     const Vec3 towards = input.closest(wrap.vertices[i]).position - wrap.vertices[i];
                     result.vertices[i] += std::min(step, norm(towards)) * normalized(towards);
                 });
    return result;
}

constexpr double wrap_edge_per_radius = 0.25;  ///< how fine the wrap of a closing is
constexpr double least_area_per_square = 1e-8; ///< of a triangle, over the square of the radius

} // namespace

TriangleMesh alpha_wrap(const TriangleMesh& surface, double alpha, double offset)
{
    require_vertices(surface);
    require_positive("alpha of the wrap [mm]", alpha);
    require_positive("offset of the wrap [mm]", offset);
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    std::vector<Kernel::Point_3> points;
    for (const Vec3& p : surface.vertices)
    {
        points.emplace_back(p.x, p.y, p.z);
    }
    std::vector<std::array<std::size_t, 3>> faces;
    for (const Triangle& t : surface.triangles)
    {
        faces.push_back(
            {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
    }
    Mesh wrap;
    CGAL::alpha_wrap_3(points, faces, alpha, offset, wrap);
    return triangles_of(wrap);
}

TriangleMesh fitted_alpha_wrap(const TriangleMesh& surface, double alpha, double offset)
{
    TriangleMesh wrap = alpha_wrap(surface, alpha, offset);
    if (wrap.triangles.empty())
    {
        return wrap;
    }
    const SurfaceTree input(surface.vertices, surface.triangles);
    const double step = mean_distance(wrap, input, offset);
    for (const double share : {1.0, 0.5})
    {
        TriangleMesh fitted = drawn_back(wrap, input, share * step);
        if (self_intersections(fitted).empty())
        {
            return fitted;
        }
    }
    return wrap;
}

TriangleMesh closed_around(const TriangleMesh& surface, double radius)
{
    const TriangleMesh wrap = alpha_wrap(surface, wrap_edge_per_radius * radius, radius);
    const SurfaceTree input(surface.vertices, surface.triangles);
    TriangleMesh closed = drawn_back(wrap, input, std::numeric_limits<double>::infinity());
    std::erase_if(closed.triangles,
                  [&](const Triangle& t)
                  {
                      const Vec3& a = closed.vertices[t[0]];
                      const double area = 0.5 * norm(cross(closed.vertices[t[1]] - a, closed.vertices[t[2]] - a));
                      return !(area > least_area_per_square * radius * radius);
                  });
    return closed;
}

} // namespace corticle::geometry
