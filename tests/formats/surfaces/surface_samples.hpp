// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace corticle
{

/// A tetrahedron whose coordinates are exact as float and in few decimals.
inline TriangleMesh tetrahedron()
{
    return {{{0, 0, 0}, {1.5, 0, 0}, {0, 2.25, 0}, {0, 0, -3}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

template <class Number>
void append(std::string& bytes, Number value, bool big_endian = false)
{
    std::array<char, sizeof(Number)> buffer;
    std::memcpy(buffer.data(), &value, sizeof(Number));
    for (std::size_t i = 0; i < sizeof(Number); ++i)
    {
        bytes.push_back(buffer[big_endian ? sizeof(Number) - 1 - i : i]);
    }
}

inline std::string position_text(const Vec3& p)
{
    return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
}

inline std::string stl_ascii(const TriangleMesh& mesh)
{
    std::string text = "solid body\n";
    for (const Triangle& t : mesh.triangles)
    {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const std::int32_t corner : t)
        {
            text += "   vertex " + position_text(mesh.vertices[static_cast<std::size_t>(corner)]) + "\n";
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid body\n";
}

inline std::string stl_binary(const TriangleMesh& mesh)
{
    std::string bytes = "solid in name only";
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles)
    {
        bytes.append(12, '\0');
        for (const std::int32_t corner : t)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                append(bytes, static_cast<float>(mesh.vertices[static_cast<std::size_t>(corner)][axis]));
            }
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

inline std::string obj_text(const TriangleMesh& mesh)
{
    std::string text = "# body\no body\n";
    for (const Vec3& v : mesh.vertices)
    {
        text += "v " + position_text(v) + "\nvn 0 0 1\n";
    }
    for (const Triangle& t : mesh.triangles)
    {
        text += "f";
        for (const std::int32_t corner : t)
        {
            const std::string number = std::to_string(corner + 1);
            text.append(" ").append(number).append("//").append(number);
        }
        text += "\n";
    }
    return text;
}

inline std::string off_text(const TriangleMesh& mesh)
{
    std::string text =
        "OFF # body\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n\n";
    for (const Vec3& v : mesh.vertices)
    {
        text += position_text(v) + "\n";
    }
    for (const Triangle& t : mesh.triangles)
    {
        text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
    }
    return text;
}

inline std::string ply_header(const TriangleMesh& mesh, const std::string& format)
{
    return "ply\nformat " + format + " 1.0\ncomment body\nelement vertex " + std::to_string(mesh.vertices.size()) +
           "\nproperty uchar quality\nproperty double x\nproperty double y\nproperty float z\nelement face " +
           std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ply_ascii(const TriangleMesh& mesh)
{
    std::string text = ply_header(mesh, "ascii");
    for (const Vec3& v : mesh.vertices)
    {
        text += "7 " + position_text(v) + "\n";
    }
    for (const Triangle& t : mesh.triangles)
    {
        text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    }
    return text;
}

inline std::string ply_binary(const TriangleMesh& mesh, bool big_endian)
{
    std::string bytes = ply_header(mesh, big_endian ? "binary_big_endian" : "binary_little_endian");
    for (const Vec3& v : mesh.vertices)
    {
        bytes.push_back(7);
        append(bytes, v.x, big_endian);
        append(bytes, v.y, big_endian);
        append(bytes, static_cast<float>(v.z), big_endian);
    }
    for (const Triangle& t : mesh.triangles)
    {
        bytes.push_back(3);
        for (const std::int32_t corner : t)
        {
            append(bytes, corner, big_endian);
        }
    }
    return bytes;
}

inline std::string vtp_ascii(const TriangleMesh& mesh)
{
    std::string points;
    std::string corners;
    std::string offsets;
    for (const Vec3& v : mesh.vertices)
    {
        points += position_text(v) + "\n";
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        for (const std::int32_t corner : mesh.triangles[t])
        {
            corners += std::to_string(corner) + " ";
        }
        offsets += std::to_string(3 * t + 3) + " ";
    }
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
           std::to_string(mesh.vertices.size()) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
           std::to_string(mesh.triangles.size()) +
           "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n" + points +
           "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
           corners + "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
           "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

/// A sample of each format that needs no library: (extension, bytes).
inline std::vector<std::pair<std::string, std::string>> surface_samples(const TriangleMesh& mesh)
{
    return {{"stl", stl_ascii(mesh)},        {"stl", stl_binary(mesh)}, {"obj", obj_text(mesh)},
            {"off", off_text(mesh)},         {"ply", ply_ascii(mesh)},  {"ply", ply_binary(mesh, false)},
            {"ply", ply_binary(mesh, true)}, {"vtp", vtp_ascii(mesh)}};
}

} // namespace corticle
