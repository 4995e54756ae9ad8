// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/tet_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::test
{

/// A box between two corners [mm], cut into n x n x n bricks of six tets each (Freudenthal).
inline TetMesh tet_box(int n, const Vec3& low, const Vec3& high)
{
    TetMesh mesh;
    const auto node = [n](int x, int y, int z) { return (x * (n + 1) + y) * (n + 1) + z; };
    for (int x = 0; x <= n; ++x)
    {
        for (int y = 0; y <= n; ++y)
        {
            for (int z = 0; z <= n; ++z)
            {
                const Vec3 part{static_cast<double>(x) / n, static_cast<double>(y) / n, static_cast<double>(z) / n};
                const Vec3 size = high - low;
                mesh.vertices.push_back(low + Vec3{part.x * size.x, part.y * size.y, part.z * size.z});
            }
        }
    }
    // From the low to the high corner of a brick, along the three axes in each of the six orders.
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int brick = 0; brick < n * n * n; ++brick)
    {
        for (int k = 0; k < 6; ++k)
        {
            int at[3] = {brick / (n * n), brick / n % n, brick % n};
            Tet tet{node(at[0], at[1], at[2]), 0, 0, 0};
            for (int step = 0; step < 3; ++step)
            {
                ++at[orders[k][step]];
                tet[static_cast<std::size_t>(step) + 1] = node(at[0], at[1], at[2]);
            }
            if (k >= 3) // odd orders give left-handed tets
            {
                std::swap(tet[2], tet[3]);
            }
            mesh.tets.push_back(tet);
        }
    }
    return mesh;
}

/// A ball about the origin: the box [-1, 1]³ pushed in along the radii.
inline TetMesh tet_ball(int n, double radius)
{
    TetMesh mesh = tet_box(n, {-1, -1, -1}, {1, 1, 1});
    for (Vec3& p : mesh.vertices)
    {
        const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        p = largest > 0.0 ? (radius * largest / norm(p)) * p : p;
    }
    return mesh;
}

/// Both meshes as one.
inline TetMesh together(const TetMesh& a, const TetMesh& b)
{
    TetMesh mesh = a;
    const auto shift = static_cast<std::int32_t>(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Tet& t : b.tets)
    {
        mesh.tets.push_back({t[0] + shift, t[1] + shift, t[2] + shift, t[3] + shift});
    }
    return mesh;
}

} // namespace corticle::test
