// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <cstddef>
#include <span>
#include <string_view>

// What is checked of arrays from outside the library, where they enter it: inside, sizes are taken for right.

namespace corticle
{

/// @throws InputError "forces: got 7 values, expected 2500" unless they are equal
void require_size(std::string_view what, std::size_t got, std::size_t expected);

/// @throws InputError "spacing [mm]: got nan, expected a finite number above 0" unless it is one
void require_positive(std::string_view what, double value);

/// @throws InputError "points: got number 4 at (0, nan, 0), expected finite coordinates" unless all are finite
void require_finite(std::string_view what, std::span<const Vec3> points);

/// @throws InputError where a triangle names a vertex that does not exist
void require_vertices(std::span<const Vec3> vertices, std::span<const Triangle> triangles);
void require_vertices(const TriangleMesh& surface);

/// @throws InputError where there is no triangle, or one names a vertex that does not exist
void require_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles);
void require_triangles(const TriangleMesh& surface);

/// @throws InputError where there is no tet, or one names a node that does not exist
void require_tets(const TetMesh& mesh);

} // namespace corticle
