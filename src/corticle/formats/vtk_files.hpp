// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/field.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <filesystem>
#include <utility>

namespace corticle::formats
{

/// Writes a surface with point fields as .vtp (binary). The file appears whole or not at all.
/// @throws RunError when it cannot be written (disk full, no permission), naming the file.
void write_surface_vtp(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles, std::span<const Field> point_fields);

/// Writes particles as .vtu, one vertex cell each, with point fields; `ids` becomes the integer array "id".
void write_particles_vtu(const std::filesystem::path& file, std::span<const Vec3> points,
                         std::span<const std::int32_t> ids, std::span<const Field> point_fields);

/// Writes the ParaView time series: (time, file name relative to the .pvd).
void write_pvd(const std::filesystem::path& file, std::span<const std::pair<double, std::string>> frames);

/// A surface read back from a .vtp this program wrote, with its point fields.
struct SurfaceFile
{
    TriangleMesh mesh;
    std::vector<std::pair<std::string, std::vector<double>>> fields; ///< scalars and vectors flattened
};
SurfaceFile read_surface_vtp(const std::filesystem::path& file);

struct ParticleFile
{
    std::vector<Vec3> points;
    std::vector<std::pair<std::string, std::vector<double>>> fields;
};
ParticleFile read_particles_vtu(const std::filesystem::path& file);

/// Frames listed in a .pvd this program wrote.
std::vector<std::pair<double, std::string>> read_pvd(const std::filesystem::path& file);

} // namespace corticle::formats
