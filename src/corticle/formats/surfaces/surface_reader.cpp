// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_reader.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/plain_file.hpp"
#include "corticle/formats/surfaces/freesurfer.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/geometry/validate.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <utility>

namespace corticle::formats
{

namespace
{

using Parser = void (*)(std::string_view, SurfaceBuilder&);

constexpr std::array<std::pair<std::string_view, Parser>, 8> parsers{{{"stl", parse_stl},
                                                                      {"obj", parse_obj},
                                                                      {"ply", parse_ply},
                                                                      {"off", parse_off},
                                                                      {"vtp", parse_vtp},
                                                                      {"gii", parse_gifti_surface},
                                                                      {"vtk", parse_legacy_vtk_surface},
                                                                      {"asc", parse_freesurfer_text}}};

/// By extension; FreeSurfer's files have none of their own and are recognised by their first bytes.
Parser parser_for(std::string_view bytes, const std::string& extension, const std::string& name)
{
    for (const auto& [known, parser] : parsers)
    {
        if (known == extension)
        {
            return parser;
        }
    }
    if (is_freesurfer_surface(bytes) || is_freesurfer_scalars(bytes))
    {
        return parse_freesurfer_surface;
    }
    fail_reading(
        name, "unknown kind of surface file", extension.empty() ? "no extension" : "." + extension,
        ".stl, .obj, .ply, .off, .vtp, .vtk, .gii, .asc or a FreeSurfer surface (labels: .nii, .nii.gz, .hdr and .img, "
        ".mgz; tets: .msh, .mesh, .vtu, .vtk)");
}

TriangleMesh parse_unmerged(std::string_view bytes, const std::string& extension, const std::string& name,
                            const SurfaceFileOptions& options)
{
    const Parser parser = parser_for(bytes, extension, name);
    SurfaceBuilder builder(name, options);
    parser(without_byte_order_mark(bytes), builder);
    return builder.finish();
}

TriangleMesh merged(const TriangleMesh& surface, const std::string& name)
{
    TriangleMesh result = geometry::merge_duplicates(surface);
    if (result.triangles.empty())
    {
        fail_reading(name, "every triangle has collapsed", "0 triangles once equal vertices are merged",
                     "at least one");
    }
    return result;
}

} // namespace

AffineMap SurfaceBuilder::chosen_map(const AffineMap& map, std::string_view source)
{
    if (map.is_identity())
    {
        return map;
    }
    if (options_.coordinates == Coordinates::file)
    {
        note(fmt::format("points are taken as they are, since coordinates = file: {} would have {} them", source,
                         describe(map)));
        return {};
    }
    note(fmt::format("points were {} by {} (coordinates = file takes them as they are)", describe(map), source));
    return map;
}

void SurfaceBuilder::note(std::string line)
{
    if (options_.notes != nullptr)
    {
        options_.notes->push_back(std::move(line));
    }
}

void SurfaceBuilder::reserve(std::size_t vertices, std::size_t triangles)
{
    mesh_.vertices.reserve(vertices);
    mesh_.triangles.reserve(triangles);
}

void SurfaceBuilder::add_vertex(const Vec3& position)
{
    if (!is_finite(position))
    {
        fail_reading(file_, fmt::format("vertex {} is not finite", vertex_count()),
                     fmt::format("({}, {}, {})", position.x, position.y, position.z), "finite coordinates");
    }
    if (vertex_count() >= std::numeric_limits<std::int32_t>::max())
    {
        fail_reading(file_, "too many vertices", "more than 2147483647", "fewer");
    }
    mesh_.vertices.push_back(position);
}

void SurfaceBuilder::add_polygon(std::span<const std::int64_t> corners)
{
    if (corners.size() < 3)
    {
        fail_reading(file_, fmt::format("polygon after {} triangles is no polygon", triangle_count()),
                     fmt::format("{} corners", corners.size()), "at least 3");
    }
    for (const std::int64_t corner : corners)
    {
        if (corner < 0 || corner > std::numeric_limits<std::int32_t>::max())
        {
            fail_reading(file_, fmt::format("polygon after {} triangles names no vertex", triangle_count()),
                         fmt::format("index {} (counted from 0)", corner), "an index from 0 on");
        }
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    {
        mesh_.triangles.push_back({static_cast<std::int32_t>(corners[0]), static_cast<std::int32_t>(corners[i]),
                                   static_cast<std::int32_t>(corners[i + 1])});
    }
}

void SurfaceBuilder::add_strip(std::span<const std::int64_t> vertices)
{
    for (std::size_t i = 2; i < vertices.size(); ++i)
    {
        const bool is_even = i % 2 == 0;
        add_polygon(std::array{vertices[i - (is_even ? 2 : 1)], vertices[i - (is_even ? 1 : 2)], vertices[i]});
    }
}

TriangleMesh SurfaceBuilder::finish()
{
    if (mesh_.triangles.empty())
    {
        fail_reading(file_, "no surface in the file", "0 triangles", "at least one");
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    {
        for (const std::int32_t corner : mesh_.triangles[t])
        {
            if (corner >= vertex_count())
            {
                fail_reading(file_, fmt::format("triangle {} names no vertex", t),
                             fmt::format("index {} (counted from 0)", corner),
                             fmt::format("at most {}", vertex_count() - 1));
            }
        }
    }
    return std::move(mesh_);
}

TriangleMesh parse_surface(std::string_view bytes, const std::string& extension, const std::string& name,
                           const SurfaceFileOptions& options)
{
    return merged(parse_unmerged(bytes, extension, name, options), name);
}

TriangleMesh read_surface_unmerged(const std::filesystem::path& file, const SurfaceFileOptions& options)
{
    const std::string name = file.string();
    const PlainFile plain = read_plain_file(file);
    TriangleMesh surface = parse_unmerged(plain.bytes, plain.extension, name, options);
    for (Vec3& vertex : surface.vertices)
    {
        vertex *= options.scale;
        if (!is_finite(vertex))
        {
            fail_reading(name, "a vertex is not finite once scaled", fmt::format("scale {}", options.scale),
                         "finite coordinates");
        }
    }
    return surface;
}

TriangleMesh read_surface(const std::filesystem::path& file, const SurfaceFileOptions& options)
{
    return merged(read_surface_unmerged(file, options), file.string());
}

} // namespace corticle::formats
