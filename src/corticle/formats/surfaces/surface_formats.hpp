// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/surfaces/volume_geometry.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Collects a surface while a file is read, and refuses what no surface may hold.
class SurfaceBuilder
{
  public:
    explicit SurfaceBuilder(std::string file, const SurfaceFileOptions& options = {})
        : file_(std::move(file)), options_(options)
    {
    }

    const std::string& file() const { return file_; }
    std::int64_t vertex_count() const { return static_cast<std::int64_t>(mesh_.vertices.size()); }
    std::int64_t triangle_count() const { return static_cast<std::int64_t>(mesh_.triangles.size()); }

    /// What becomes of a map to scanner space that the file describes: as the options say it is applied or not, and a
    /// note tells. @param source  where it stands, as in "the volume geometry of the file"
    AffineMap chosen_map(const AffineMap& map, std::string_view source);
    /// Something of the file that was not taken as it stands.
    void note(std::string line);

    /// Sizes announced by the file; at most what its bytes can hold.
    void reserve(std::size_t vertices, std::size_t triangles);
    /// @throws InputError for a coordinate that is not finite.
    void add_vertex(const Vec3& position);
    /// Fans a polygon of vertex indices from 0 into triangles. @throws InputError for fewer than three corners or a
    /// negative index.
    void add_polygon(std::span<const std::int64_t> corners);
    /// A strip of triangles: every vertex makes one with the two before it, of changing sense. @throws InputError as
    /// above
    void add_strip(std::span<const std::int64_t> vertices);
    /// @throws InputError for no triangle or an index that names no vertex.
    TriangleMesh finish();

  private:
    std::string file_;
    SurfaceFileOptions options_;
    TriangleMesh mesh_;
};

// One parser for each format; each throws InputError for whatever is not its format.
void parse_stl(std::string_view bytes, SurfaceBuilder& surface);
void parse_obj(std::string_view bytes, SurfaceBuilder& surface);
void parse_ply(std::string_view bytes, SurfaceBuilder& surface);
void parse_off(std::string_view bytes, SurfaceBuilder& surface);
void parse_vtp(std::string_view bytes, SurfaceBuilder& surface);
void parse_gifti_surface(std::string_view bytes, SurfaceBuilder& surface);
void parse_legacy_vtk_surface(std::string_view bytes, SurfaceBuilder& surface);
void parse_freesurfer_surface(std::string_view bytes, SurfaceBuilder& surface);
void parse_freesurfer_text(std::string_view bytes, SurfaceBuilder& surface);

} // namespace corticle::formats
