// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// A triangulated surface [mm].
struct TriangleMesh
{
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

/// Sum of triangle areas [mm²].
double surface_area(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// Volume enclosed by a closed surface, positive when its normals point outward [mm³] (divergence theorem).
double enclosed_volume(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// Area over the area of the sphere that encloses the same volume.
double sphere_index(double area, double volume);

/// Unit vertex normals, weighted by the angles of the incident triangles (Baerentzen & Aanaes 2005).
std::vector<Vec3> vertex_normals(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// A third of the area of the incident triangles, for each vertex [mm²].
std::vector<double> vertex_areas(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

} // namespace corticle
