// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle
{

/// Node indices; right-handed: seen from the last node, the first three run clockwise (as in Gmsh and VTK).
using Tet = std::array<std::int32_t, 4>;

/// A tetrahedral mesh of a body [mm].
struct TetMesh
{
    std::vector<Vec3> vertices;
    std::vector<Tet> tets;
};

/// Corners of the faces of a right-handed tet, counter-clockwise seen from outside; face k is opposite to corner k.
inline constexpr std::array<std::array<int, 3>, 4> tet_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Volume of a tet [mm³], positive when right-handed.
double signed_volume(std::span<const Vec3> vertices, const Tet& tet);

/// Signed volume of every tet [mm³].
std::vector<double> tet_volumes(const TetMesh& mesh);

/// Lumped volumes: a quarter of every tet to each of its nodes [mm³]; their sum is the volume of the mesh.
std::vector<double> node_volumes(const TetMesh& mesh);

/// Centroids of those quarters, each the part of the tet where its node has the largest barycentric coordinate [mm].
std::vector<Vec3> node_centroids(const TetMesh& mesh);

/// Shape of a tet: 12 (3 V)^(2/3) / sum of squared edges (mean ratio, Liu & Joe 1994), 1 for a regular tet, 0 for a
/// flat one, whatever its sense.
double mean_ratio(std::span<const Vec3> vertices, const Tet& tet);

/// The tet across each face of each tet, -1 where there is none.
using TetNeighbors = std::vector<std::array<std::int32_t, 4>>;

/// A face as two tets of a broken mesh share it.
struct FaceFault
{
    std::int64_t crowded = 0;   ///< faces of more than two tets
    std::int64_t same_side = 0; ///< faces of two tets on the same side, which then overlap
    Triangle example{-1, -1, -1};
};

/// Neighbours across faces, for tets that are all right-handed. What keeps a face from having a tet on each side is
/// counted in `fault`.
TetNeighbors tet_neighbors(const TetMesh& mesh, FaceFault* fault = nullptr);

/// Boundary of a tet mesh: closed, its normals outward.
struct TetBoundary
{
    TriangleMesh surface;            ///< vertices in ascending order of their nodes
    std::vector<std::int32_t> nodes; ///< node that each vertex is
};

/// Faces with one tet, for right-handed tets.
TetBoundary boundary_of(const TetMesh& mesh);
TetBoundary boundary_of(const TetMesh& mesh, const TetNeighbors& neighbors);

} // namespace corticle
