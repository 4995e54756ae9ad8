// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_writer.hpp"

#include "corticle/formats/atomic_file.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstdint>

namespace corticle::formats
{

namespace
{

/// Little endian, as every machine this runs on.
template <class Number>
void put(std::string& bytes, Number value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Number));
}

std::string property_name(std::string name)
{
    for (char& c : name)
    {
        const bool suits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        c = suits ? c : '_';
    }
    return name.empty() ? "scalar" : name;
}

void put_single(std::string& bytes, const Vec3& p)
{
    put(bytes, static_cast<float>(p.x));
    put(bytes, static_cast<float>(p.y));
    put(bytes, static_cast<float>(p.z));
}

} // namespace

void write_surface_ply(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles, std::span<const Field> scalars)
{
    std::string bytes = fmt::format("ply\nformat binary_little_endian 1.0\ncomment corticle, mm\nelement vertex {}\n"
                                    "property double x\nproperty double y\nproperty double z\n",
                                    points.size());
    for (const Field& field : scalars)
    {
        assert(field.components == 1 && field.values.size() == points.size());
        bytes += fmt::format("property double {}\n", property_name(field.name));
    }
    bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        put(bytes, points[i].x);
        put(bytes, points[i].y);
        put(bytes, points[i].z);
        for (const Field& field : scalars)
        {
            put(bytes, field.values[i]);
        }
    }
    for (const Triangle& t : triangles)
    {
        bytes.push_back(3);
        for (const std::int32_t corner : t)
        {
            put(bytes, corner);
        }
    }
    write_text_atomically(file, bytes);
}

void write_surface_stl(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles)
{
    std::string bytes = "corticle, mm";
    bytes.resize(80, ' ');
    put(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles)
    {
        const Vec3& a = points[static_cast<std::size_t>(t[0])];
        const Vec3& b = points[static_cast<std::size_t>(t[1])];
        const Vec3& c = points[static_cast<std::size_t>(t[2])];
        put_single(bytes, normalized(cross(b - a, c - a)));
        put_single(bytes, a);
        put_single(bytes, b);
        put_single(bytes, c);
        put(bytes, std::uint16_t{0});
    }
    write_text_atomically(file, bytes);
}

} // namespace corticle::formats
