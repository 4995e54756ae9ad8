// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/field.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <filesystem>

namespace corticle::formats
{

/// Writes a surface as binary PLY: coordinates [mm] and scalars per vertex as double, the latter as properties; what
/// does not suit a property's name becomes '_'. The file appears whole or not at all. @throws RunError
void write_surface_ply(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles, std::span<const Field> scalars = {});

/// Writes a surface as binary STL: float32 [mm], no scalars. @throws RunError
void write_surface_stl(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles);

} // namespace corticle::formats
