// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/surfaces/surface_formats.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace corticle::formats
{

enum class PlyType
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64,
    unknown
};

struct PlyProperty
{
    std::string_view name;
    PlyType type = PlyType::unknown;
    PlyType count_type = PlyType::unknown; ///< set for a list
    bool is_list = false;
};

struct PlyElement
{
    std::string_view name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyFormat
{
    none,
    ascii,
    little_endian,
    big_endian
};

struct PlyHeader
{
    PlyFormat format = PlyFormat::none;
    std::vector<PlyElement> elements;
};

/// Reads up to and with end_header; `text` then begins with the data.
/// @throws InputError, one line, when it is no PLY header.
PlyHeader take_ply_header(std::string_view& text, const SurfaceBuilder& surface);

} // namespace corticle::formats
