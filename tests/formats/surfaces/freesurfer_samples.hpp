// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/surfaces/surface_samples.hpp"

#include <fmt/format.h>

namespace corticle
{

/// A structure of a colour table.
struct SampleStructure
{
    std::int32_t number;
    std::string name;
    std::array<std::int32_t, 3> colour;
};

inline std::int32_t packed_colour(const std::array<std::int32_t, 3>& colour)
{
    return colour[0] | colour[1] << 8 | colour[2] << 16;
}

inline void append_text(std::string& bytes, const std::string& text)
{
    append(bytes, static_cast<std::int32_t>(text.size() + 1), true);
    bytes += text;
    bytes.push_back('\0');
}

/// @param is_new  the colour table of version 2, which numbers its structures; else of version 1, in order
inline std::string annotation(const std::vector<std::int32_t>& colours, const std::vector<SampleStructure>& table,
                              bool is_new = true)
{
    std::string bytes;
    append(bytes, static_cast<std::int32_t>(colours.size()), true);
    for (std::size_t k = 0; k < colours.size(); ++k)
    {
        append(bytes, static_cast<std::int32_t>(k), true);
        append(bytes, colours[k], true);
    }
    append(bytes, std::int32_t{1}, true);
    const auto count = static_cast<std::int32_t>(table.size());
    append(bytes, is_new ? std::int32_t{-2} : count, true);
    if (is_new)
    {
        append(bytes, std::int32_t{100}, true);
    }
    append_text(bytes, "table.ctab");
    if (is_new)
    {
        append(bytes, count, true);
    }
    for (const SampleStructure& structure : table)
    {
        if (is_new)
        {
            append(bytes, structure.number, true);
        }
        append_text(bytes, structure.name);
        for (const std::int32_t channel : structure.colour)
        {
            append(bytes, channel, true);
        }
        append(bytes, std::int32_t{0}, true);
    }
    return bytes;
}

inline std::string freesurfer_text_surface(const TriangleMesh& mesh)
{
    std::string text = fmt::format("#!ascii version of lh.white\n{} {}\n", mesh.vertices.size(), mesh.triangles.size());
    for (const Vec3& v : mesh.vertices)
    {
        text += position_text(v) + "  0\n";
    }
    for (const Triangle& t : mesh.triangles)
    {
        text += fmt::format("{} {} {} 0\n", t[0], t[1], t[2]);
    }
    return text;
}

} // namespace corticle
