// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::test
{

/// A box between two corners [mm], 12 triangles.
inline TriangleMesh box(const Vec3& low, const Vec3& high)
{
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
    {
        mesh.vertices.push_back({(k & 1) ? high.x : low.x, (k & 2) ? high.y : low.y, (k & 4) ? high.z : low.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Both meshes as one.
inline TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b)
{
    TriangleMesh mesh = a;
    const auto shift = static_cast<std::int32_t>(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles)
    {
        mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    return mesh;
}

} // namespace corticle::test
