// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::test
{

/// The unit cube in bricks of six tets each (Freudenthal), so many along each axis.
inline TetMesh tet_grid(int along_x, int along_y, int along_z)
{
    TetMesh mesh;
    const auto node = [=](int x, int y, int z) { return (x * (along_y + 1) + y) * (along_z + 1) + z; };
    for (int x = 0; x <= along_x; ++x)
    {
        for (int y = 0; y <= along_y; ++y)
        {
            for (int z = 0; z <= along_z; ++z)
            {
                mesh.vertices.push_back({static_cast<double>(x) / along_x, static_cast<double>(y) / along_y,
                                         static_cast<double>(z) / along_z});
            }
        }
    }
    // From the low to the high corner of a brick, along the three axes in each of the six orders.
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int brick = 0; brick < along_x * along_y * along_z; ++brick)
    {
        for (int k = 0; k < 6; ++k)
        {
            int at[3] = {brick / (along_y * along_z), brick / along_z % along_y, brick % along_z};
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

/// A box between two corners [mm], cut into n x n x n bricks of six tets each.
inline TetMesh tet_box(int n, const Vec3& low, const Vec3& high)
{
    TetMesh mesh = tet_grid(n, n, n);
    const Vec3 size = high - low;
    for (Vec3& p : mesh.vertices)
    {
        p = low + Vec3{p.x * size.x, p.y * size.y, p.z * size.z};
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
