// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/freesurfer.hpp"

#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/surfaces/volume_geometry.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::formats
{

namespace
{

constexpr std::string_view surface_magic = "\xff\xff\xfe";
constexpr std::string_view scalars_magic = "\xff\xff\xff"; // also of surfaces of quadrangles
constexpr std::string_view new_quadrangles_magic = "\xff\xff\xfd";

// What may stand behind a surface.
constexpr std::int32_t tag_real_ras = 2;
constexpr std::int32_t tag_volume_geometry = 20;

template <class Number>
Number take(std::string_view& bytes)
{
    const auto value = load<Number>(bytes.data(), true);
    bytes.remove_prefix(sizeof(Number));
    return value;
}

template <class Number>
void put(std::string& bytes, Number value)
{
    char stored[sizeof(Number)];
    std::memcpy(stored, &value, sizeof(Number));
    for (std::size_t i = sizeof(Number); i > 0; --i)
    {
        bytes.push_back(stored[i - 1]);
    }
}

/// "key = a b c # comment" of the volume geometry; false where three numbers do not follow the key.
bool take_direction(std::string_view line, Vec3& direction)
{
    line.remove_prefix(std::min(line.size(), line.find('=') + 1));
    return to_number(take_word(line), direction.x) && to_number(take_word(line), direction.y) &&
           to_number(take_word(line), direction.z);
}

/// The volume geometry as text lines; nothing when it says that it is not valid.
std::optional<AffineMap> parse_volume_geometry(std::string_view text, const std::string& name)
{
    VolumeGeometry volume;
    constexpr int line_count = 8; // valid, filename, volume, voxelsize, xras, yras, zras, cras
    int directions = 0;
    std::string_view line;
    for (int k = 0; k < line_count && take_line(text, line); ++k)
    {
        std::string_view rest = line;
        const std::string_view key = take_word(rest);
        if (key == "valid" && take_word(rest) == "=" && take_word(rest) != "1")
        {
            return std::nullopt;
        }
        Vec3* direction = key == "xras"   ? &volume.x_ras
                          : key == "yras" ? &volume.y_ras
                          : key == "zras" ? &volume.z_ras
                          : key == "cras" ? &volume.c_ras
                                          : nullptr;
        directions += direction != nullptr && take_direction(line, *direction) ? 1 : 0;
    }
    const std::optional<AffineMap> map = tkras_to_scanner(volume);
    if (directions != 4 || !map)
    {
        fail_reading(name, "bad volume geometry behind a FreeSurfer surface",
                     fmt::format("{} of xras, yras, zras and cras, or axes that do not span space", directions),
                     "three unit vectors and a centre");
    }
    return map;
}

/// From the coordinates of the file to scanner RAS, as the tags behind the triangles say.
AffineMap to_scanner(std::string_view tags, const std::string& name)
{
    while (tags.size() >= sizeof(std::int32_t))
    {
        const auto tag = take<std::int32_t>(tags);
        if (tag == tag_volume_geometry)
        {
            return parse_volume_geometry(tags, name).value_or(AffineMap{});
        }
        if (tag != tag_real_ras || tags.size() < sizeof(std::int32_t) || take<std::int32_t>(tags) != 0)
        {
            return {}; // the coordinates are scanner RAS already, or nothing is known
        }
    }
    return {};
}

} // namespace

bool is_freesurfer_surface(std::string_view bytes)
{
    return bytes.starts_with(surface_magic);
}

bool is_freesurfer_scalars(std::string_view bytes)
{
    return bytes.starts_with(scalars_magic);
}

void parse_freesurfer_surface(std::string_view bytes, SurfaceBuilder& surface)
{
    const std::string& name = surface.file();
    if (bytes.starts_with(scalars_magic) || bytes.starts_with(new_quadrangles_magic))
    {
        fail_reading(name, "not a FreeSurfer triangle surface", "a surface of quadrangles or a file of scalars",
                     "triangles (mris_convert makes them)");
    }
    if (!is_freesurfer_surface(bytes))
    {
        fail_reading(name, "not a FreeSurfer surface", bytes.empty() ? "an empty file" : "other bytes",
                     "ff ff fe at the start");
    }
    bytes.remove_prefix(surface_magic.size());
    // Who made it, in a line that most writers end with two newlines, some with one. A second newline is not a number:
    // it would begin a count of 160 million.
    bytes.remove_prefix(std::min(bytes.size(), bytes.find('\n') + 1));
    bytes.remove_prefix(bytes.starts_with('\n') ? 1 : 0);
    const bool has_counts = bytes.size() >= 2 * sizeof(std::int32_t);
    const std::int64_t vertices = has_counts ? take<std::int32_t>(bytes) : -1;
    const std::int64_t triangles = has_counts ? take<std::int32_t>(bytes) : -1;
    const auto size = static_cast<std::int64_t>(bytes.size());
    if (vertices < 0 || triangles < 0 || 12 * (vertices + triangles) > size)
    {
        fail_reading(name, "truncated FreeSurfer surface",
                     fmt::format("{} vertices and {} triangles in {} bytes", vertices, triangles, size),
                     "12 bytes for each");
    }
    surface.reserve(static_cast<std::size_t>(vertices), static_cast<std::size_t>(triangles));
    const AffineMap map =
        surface.chosen_map(to_scanner(bytes.substr(static_cast<std::size_t>(12 * (vertices + triangles))), name),
                           "the volume geometry behind the triangles");
    for (std::int64_t v = 0; v < vertices; ++v)
    {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] = take<float>(bytes);
        }
        surface.add_vertex(map(p));
    }
    for (std::int64_t t = 0; t < triangles; ++t)
    {
        std::array<std::int64_t, 3> corners{};
        for (std::int64_t& corner : corners)
        {
            corner = take<std::int32_t>(bytes);
        }
        if (map.mirrors())
        {
            std::swap(corners[1], corners[2]);
        }
        surface.add_polygon(corners);
    }
}

std::vector<double> parse_freesurfer_scalars(std::string_view bytes, const std::string& name)
{
    if (!is_freesurfer_scalars(bytes))
    {
        fail_reading(name, "not a FreeSurfer file of scalars", bytes.empty() ? "an empty file" : "other bytes",
                     "ff ff ff at the start (the new curv format)");
    }
    bytes.remove_prefix(scalars_magic.size());
    const bool has_counts = bytes.size() >= 3 * sizeof(std::int32_t);
    const std::int64_t vertices = has_counts ? take<std::int32_t>(bytes) : -1;
    if (has_counts)
    {
        take<std::int32_t>(bytes); // triangles of the surface
    }
    const std::int32_t per_vertex = has_counts ? take<std::int32_t>(bytes) : -1;
    if (vertices < 0 || per_vertex != 1 || 4 * vertices > static_cast<std::int64_t>(bytes.size()))
    {
        fail_reading(name, "truncated or damaged FreeSurfer file of scalars",
                     fmt::format("{} vertices, {} values each, in {} bytes", vertices, per_vertex, bytes.size()),
                     "one value of 4 bytes for each vertex");
    }
    std::vector<double> values(static_cast<std::size_t>(vertices));
    for (double& value : values)
    {
        value = take<float>(bytes);
    }
    return values;
}

void write_surface_freesurfer(const std::filesystem::path& file, std::span<const Vec3> points,
                              std::span<const Triangle> triangles)
{
    std::string bytes(surface_magic);
    bytes += "created by corticle\n\n";
    put(bytes, static_cast<std::int32_t>(points.size()));
    put(bytes, static_cast<std::int32_t>(triangles.size()));
    for (const Vec3& p : points)
    {
        put(bytes, static_cast<float>(p.x));
        put(bytes, static_cast<float>(p.y));
        put(bytes, static_cast<float>(p.z));
    }
    for (const Triangle& t : triangles)
    {
        for (const std::int32_t corner : t)
        {
            put(bytes, corner);
        }
    }
    put(bytes, tag_real_ras);
    put(bytes, std::int32_t{0});
    put(bytes, tag_volume_geometry);
    bytes += "valid = 1  # volume info valid\n"
             "filename = none\n"
             "volume = 256 256 256\n"
             "voxelsize = 1.000000000000000e+00 1.000000000000000e+00 1.000000000000000e+00\n"
             "xras   = -1.000000000000000e+00 0.000000000000000e+00 0.000000000000000e+00\n"
             "yras   = 0.000000000000000e+00 0.000000000000000e+00 -1.000000000000000e+00\n"
             "zras   = 0.000000000000000e+00 1.000000000000000e+00 0.000000000000000e+00\n"
             "cras   = 0.000000000000000e+00 0.000000000000000e+00 0.000000000000000e+00\n";
    write_text_atomically(file, bytes);
}

void write_scalars_freesurfer(const std::filesystem::path& file, std::span<const double> values,
                              std::size_t triangle_count)
{
    std::string bytes(scalars_magic);
    put(bytes, static_cast<std::int32_t>(values.size()));
    put(bytes, static_cast<std::int32_t>(triangle_count));
    put(bytes, std::int32_t{1});
    for (const double value : values)
    {
        put(bytes, static_cast<float>(value));
    }
    write_text_atomically(file, bytes);
}

} // namespace corticle::formats
