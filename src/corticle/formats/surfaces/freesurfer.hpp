// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// FreeSurfer's binary files, big endian: triangle surfaces (lh.white, lh.pial: magic ff ff fe) and scalars per vertex
// in the "new" curv format (lh.thickness, lh.curv, lh.sulc: magic ff ff ff).

namespace corticle::formats
{

bool is_freesurfer_surface(std::string_view bytes);
bool is_freesurfer_scalars(std::string_view bytes);

/// Scalars per vertex. @throws InputError, one line naming `name`, for what is not such a file, or is damaged
std::vector<double> parse_freesurfer_scalars(std::string_view bytes, const std::string& name);

/// Writes a triangle surface whose coordinates are scanner RAS [mm], as float32. The volume geometry behind it says
/// so: a conformed volume centred at the scanner's origin, for which surface and scanner coordinates are the same.
/// @throws RunError when it cannot be written.
void write_surface_freesurfer(const std::filesystem::path& file, std::span<const Vec3> points,
                              std::span<const Triangle> triangles);

/// Writes scalars per vertex as float32. `triangle_count` is that of the surface they belong to. @throws RunError
void write_scalars_freesurfer(const std::filesystem::path& file, std::span<const double> values,
                              std::size_t triangle_count);

} // namespace corticle::formats
