// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/hull.hpp"

#include "corticle/base/error.hpp"
#include "corticle/mesh/sizes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

namespace corticle::geometry
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

bool all_in_one_plane(const std::vector<Point>& points)
{
    const auto other = std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != points[0]; });
    if (other == points.end())
    {
        return true;
    }
    const auto third =
        std::find_if(other, points.end(), [&](const Point& p) { return !CGAL::collinear(points[0], *other, p); });
    return third == points.end() ||
           std::all_of(third, points.end(),
                       [&](const Point& p) { return CGAL::coplanar(points[0], *other, *third, p); });
}

std::int32_t index(Mesh::Vertex_index vertex)
{
    return static_cast<std::int32_t>(vertex.idx());
}

/// Vertices in lexicographic order, triangles too, each from its lowest vertex: CGAL's order varies from run to run.
void sort_elements(TriangleMesh& mesh)
{
    std::vector<std::int32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::int32_t a, std::int32_t b)
              {
                  const Vec3& p = mesh.vertices[a];
                  const Vec3& q = mesh.vertices[b];
                  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
              });
    std::vector<Vec3> vertices;
    std::vector<std::int32_t> number(mesh.vertices.size());
    for (const std::int32_t vertex : order)
    {
        number[vertex] = static_cast<std::int32_t>(vertices.size());
        vertices.push_back(mesh.vertices[vertex]);
    }
    mesh.vertices = std::move(vertices);
    for (Triangle& t : mesh.triangles)
    {
        t = {number[t[0]], number[t[1]], number[t[2]]};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(mesh.triangles.begin(), mesh.triangles.end());
}

} // namespace

TriangleMesh convex_hull(std::span<const Vec3> points)
{
    require_finite("convex hull: points", points);
    std::vector<Point> input;
    input.reserve(points.size());
    for (const Vec3& p : points)
    {
        input.emplace_back(p.x, p.y, p.z);
    }
    if (input.size() < 4 || all_in_one_plane(input))
    {
        throw InputError("convex hull: " + std::to_string(points.size()) +
                         " points in one plane; expected at least 4 that span a volume");
    }
    Mesh hull;
    CGAL::convex_hull_3(input.begin(), input.end(), hull);
    TriangleMesh result;
    for (const auto v : hull.vertices())
    {
        const Point& p = hull.point(v);
        result.vertices.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto f : hull.faces())
    {
        const auto h = hull.halfedge(f);
        const auto first = hull.target(h);
        for (auto g = hull.next(h); hull.target(hull.next(g)) != first; g = hull.next(g))
        {
            result.triangles.push_back({index(first), index(hull.target(g)), index(hull.target(hull.next(g)))});
        }
    }
    sort_elements(result);
    return result;
}

} // namespace corticle::geometry
