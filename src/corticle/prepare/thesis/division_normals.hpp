// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::prepare
{

/// Lines along the normals of a surface's triangles: a point of each and its direction.
struct NormalLines
{
    std::vector<Vec3> points;  ///< centroids [mm]
    std::vector<Vec3> normals; ///< unit, outward
};

/// The normal lines of all triangles.
NormalLines triangle_normal_lines(const TriangleMesh& surface);

/// Which of equal pieces of a body a point is in, from 0: half as many equal wedges about the line through the centre
/// along z, each cut at the height of the centre. 4 pieces are quarters, 8 octants.
std::int32_t division_of(const Vec3& point, std::int32_t divisions, const Vec3& centre);

/// Normals as the thesis takes them (section 2.4.2): of the normal lines in the particle's own piece of the body, the
/// direction of the one that passes nearest to it. Lines are infinite, so on a body that is not a sphere the nearest
/// may belong to a far part of the surface.
/// @param positions  reference [mm]
/// @param divisions  number of pieces, even
/// @param centre     where the pieces meet [mm]
/// @return unit normals, one per particle
/// @throws InputError when the number of pieces is odd or not from 2 to 1024, or a piece holds particles and no line
std::vector<Vec3> division_normals(std::span<const Vec3> positions, const NormalLines& lines, std::int32_t divisions,
                                   const Vec3& centre);

} // namespace corticle::prepare
