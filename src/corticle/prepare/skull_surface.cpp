// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/skull_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/cloud/cloud_options.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/geometry/alpha_wrap.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/surface_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace corticle::prepare
{

namespace
{

using boundary::SkullShape;

constexpr double least_clearance = 0.05; ///< between brain and skull at the start [spacings]

/// The surface of the body at a distance; fissures that a ball of twice the spacing cannot enter are bridged.
TriangleMesh offset_surface(const PreparationOptions& options, const TriangleMesh& surface, double spacing, double edge)
{
    const double distance = options.boundary.offset_mm;
    if (options.geometry.shape == Shape::sphere || options.geometry.shape == Shape::ellipsoid)
    {
        TriangleMesh moved = surface;
        const std::vector<Vec3> normals = vertex_normals(surface.vertices, surface.triangles);
        for (std::size_t k = 0; k < normals.size(); ++k)
        {
            moved.vertices[k] += distance * normals[k];
        }
        return geometry::remesh_isotropic(moved, edge);
    }
    return geometry::remesh_isotropic(geometry::alpha_wrap(surface, 2.0 * spacing, distance), edge);
}

TriangleMesh file_surface(const PreparationOptions& options, double edge)
{
    const std::string& file = options.boundary.file;
    const TriangleMesh read = formats::read_surface(
        file, {formats::millimetres_per(options.geometry.unit), options.geometry.coordinates, nullptr});
    return geometry::remesh_isotropic(
        geometry::repair_surface(read, file, geometry::Repair::none, options.geometry.wrap).mesh, edge);
}

TriangleMesh ellipsoid_surface(const boundary::BoundaryOptions& skull, double edge)
{
    TriangleMesh mesh = geometry::make_ellipsoid(skull.semi_axes_mm, edge);
    for (Vec3& vertex : mesh.vertices)
    {
        vertex += Vec3{skull.centre_mm[0], skull.centre_mm[1], skull.centre_mm[2]};
    }
    return mesh;
}

/// Least distance of the brain from the skull, negative where some of it is outside [mm].
double clearance_of(const TriangleMesh& brain, const TriangleMesh& skull)
{
    const geometry::SurfaceTree around(skull.vertices, skull.triangles);
    const geometry::SurfaceTree within(brain.vertices, brain.triangles);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : brain.vertices)
    {
        least = std::min(least, -around.signed_distance(vertex));
    }
    for (const Vec3& vertex : skull.vertices)
    {
        least = std::min(least, within.signed_distance(vertex));
    }
    return least;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b)
{
    TriangleMesh both = a;
    const auto first = static_cast<std::int32_t>(a.vertices.size());
    both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles)
    {
        both.triangles.push_back({first + i, first + j, first + k});
    }
    return both;
}

} // namespace

TriangleMesh skull_surface(const PreparationOptions& options, const model::Model& model)
{
    const double spacing = model.cloud.spacing;
    const double edge = cloud::edge_per_spacing * spacing;
    TriangleMesh skull;
    switch (options.boundary.shape)
    {
    case SkullShape::none:
        return skull;
    case SkullShape::offset:
        skull = offset_surface(options, model.surface, spacing, edge);
        break;
    case SkullShape::ellipsoid:
        skull = ellipsoid_surface(options.boundary, edge);
        break;
    case SkullShape::file:
        skull = file_surface(options, edge);
        break;
    }
    const double clearance = clearance_of(model.surface, skull);
    if (clearance < least_clearance * spacing || geometry::intersecting_triangles(joined(model.surface, skull)) > 0)
    {
        throw InputError(fmt::format("boundary: the skull does not enclose the body: got a clearance of {:.4g} mm, "
                                     "expected at least {:.4g} mm all around",
                                     clearance, least_clearance * spacing));
    }
    return skull;
}

} // namespace corticle::prepare
