// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/mend.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/cgal_triangles.hpp"
#include "corticle/geometry/surface_faults.hpp"
#include "corticle/mesh/sizes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <string>

namespace corticle::geometry
{

namespace
{

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

std::vector<Point> points_of(const TriangleMesh& surface)
{
    std::vector<Point> points;
    points.reserve(surface.vertices.size());
    for (const Vec3& p : surface.vertices)
    {
        points.emplace_back(p.x, p.y, p.z);
    }
    return points;
}

/// Without the vertices that no triangle uses.
TriangleMesh from_cgal(Mesh& mesh)
{
    const TriangleMesh all = triangles_of(mesh);
    return kept_triangles(all, std::vector<char>(all.triangles.size(), 1));
}

void fill_hole(Mesh& mesh, Mesh::Halfedge_index rim)
{
    std::vector<Mesh::Face_index> faces;
    std::vector<Mesh::Vertex_index> vertices;
    pmp::triangulate_refine_and_fair_hole(mesh, rim, std::back_inserter(faces), std::back_inserter(vertices));
    if (faces.empty())
    {
        std::int64_t edges = 0;
        for (auto h = rim; edges == 0 || h != rim; h = mesh.next(h))
        {
            ++edges;
        }
        throw InputError("a hole of " + std::to_string(edges) + " edges could not be filled");
    }
}

} // namespace

TriangleMesh orient_and_fill_holes(const TriangleMesh& surface, std::int64_t& filled)
{
    require_vertices(surface);
    std::vector<Point> points = points_of(surface);
    std::vector<std::vector<std::size_t>> polygons;
    polygons.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles)
    {
        polygons.push_back(
            {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
    }
    pmp::orient_polygon_soup(points, polygons);
    Mesh mesh;
    pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    pmp::stitch_borders(mesh);
    std::vector<Mesh::Halfedge_index> rims;
    pmp::extract_boundary_cycles(mesh, std::back_inserter(rims));
    for (const Mesh::Halfedge_index rim : rims)
    {
        fill_hole(mesh, rim);
    }
    filled = static_cast<std::int64_t>(rims.size());
    pmp::remove_degenerate_faces(mesh);
    return from_cgal(mesh);
}

bool remove_self_intersections(TriangleMesh& surface)
{
    require_vertices(surface);
    auto mesh = cgal_mesh<Mesh>(surface);
    if (!pmp::experimental::remove_self_intersections(mesh, pmp::parameters::preserve_genus(true)))
    {
        return false;
    }
    surface = from_cgal(mesh);
    return true;
}

} // namespace corticle::geometry
