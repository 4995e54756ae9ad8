// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/remesh.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/cgal_triangles.hpp"
#include "corticle/geometry/even_out.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/mesh/sizes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <string>

namespace corticle::geometry
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr unsigned iterations = 6;
constexpr unsigned relaxation_steps = 3;

/// Largest distance of vertices and centroids to a surface [mm].
double largest_distance(const TriangleMesh& mesh, const SurfaceTree& surface)
{
    const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
    const auto triangles = static_cast<std::int64_t>(mesh.triangles.size());
    return std::sqrt(parallel_reduce(
        vertices + triangles, 0.0,
        [&](std::int64_t begin, std::int64_t end)
        {
            double largest = 0.0;
            for (std::int64_t k = begin; k < end; ++k)
            {
                const Triangle t = k < vertices ? Triangle{} : mesh.triangles[k - vertices];
                const Vec3 centroid = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
                const Vec3 place = k < vertices ? mesh.vertices[k] : centroid;
                largest = std::max(largest, surface.closest(place).squared_distance);
            }
            return largest;
        },
        [](double& total, double part) { total = std::max(total, part); }));
}

} // namespace

TriangleMesh remesh_isotropic(const TriangleMesh& surface, double edge_length, RemeshReport* report)
{
    require_triangles(surface);
    require_positive("remeshing: edge length [mm]", edge_length);
    namespace pmp = CGAL::Polygon_mesh_processing;
    Mesh mesh = cgal_mesh<Mesh>(surface);
    pmp::isotropic_remeshing(mesh.faces(), edge_length, mesh,
                             pmp::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(relaxation_steps)
                                 .do_project(true));
    TriangleMesh result = triangles_of(mesh);
    const SurfaceTree tree(surface.vertices, surface.triangles);
    parallel_for(static_cast<std::int64_t>(result.vertices.size()),
                 [&](std::int64_t i) { result.vertices[i] = tree.closest(result.vertices[i]).position; });
    require_valid_surface(result, "surface remeshed to edges of " + std::to_string(edge_length) + " mm");
    even_out(result, tree, edge_length);
    if (report != nullptr)
    {
        const double area = surface_area(surface.vertices, surface.triangles);
        const double volume = enclosed_volume(surface.vertices, surface.triangles);
        report->area_change = surface_area(result.vertices, result.triangles) / area - 1.0;
        report->volume_change = enclosed_volume(result.vertices, result.triangles) / volume - 1.0;
        report->largest_distance_mm = largest_distance(result, tree);
    }
    return result;
}

} // namespace corticle::geometry
