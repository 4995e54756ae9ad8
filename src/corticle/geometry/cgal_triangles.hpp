// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

// Templates, so that no header of CGAL is needed here.

/// A CGAL::Surface_mesh of the same vertices and triangles, in their order.
template <class Mesh>
Mesh cgal_mesh(const TriangleMesh& surface)
{
    Mesh mesh;
    for (const Vec3& p : surface.vertices)
    {
        mesh.add_vertex({p.x, p.y, p.z});
    }
    using Vertex = typename Mesh::Vertex_index;
    for (const Triangle& t : surface.triangles)
    {
        mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    }
    return mesh;
}

/// The vertices and triangles of a CGAL::Surface_mesh, in their order, once its garbage is collected.
template <class Mesh>
TriangleMesh triangles_of(Mesh& mesh)
{
    mesh.collect_garbage();
    TriangleMesh result;
    for (const auto v : mesh.vertices())
    {
        const auto& p = mesh.point(v);
        result.vertices.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto f : mesh.faces())
    {
        const auto h = mesh.halfedge(f);
        result.triangles.push_back({static_cast<std::int32_t>(mesh.target(h)),
                                    static_cast<std::int32_t>(mesh.target(mesh.next(h))),
                                    static_cast<std::int32_t>(mesh.target(mesh.next(mesh.next(h))))});
    }
    return result;
}

} // namespace corticle::geometry
