// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// The vertices and triangles of a CGAL::Surface_mesh, in their order, once its garbage is collected. A template, so
/// that no header of CGAL is needed here.
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
