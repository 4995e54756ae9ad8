// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <cstddef>
#include <span>
#include <string_view>

// What is checked of arrays from outside the library, where they enter it: inside, sizes are taken for right.

namespace corticle
{

/// @throws InputError "forces: got 7 values, expected 2500" unless they are equal
void require_size(std::string_view what, std::size_t got, std::size_t expected);

/// @throws InputError where there is no triangle, or one names a vertex that does not exist
void require_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

} // namespace corticle
