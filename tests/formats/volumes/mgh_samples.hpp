// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"
#include "formats/surfaces/surface_samples.hpp"

namespace corticle
{

/// An MGH file field by field.
struct MghSample
{
    std::array<std::int32_t, 4> size{4, 3, 2, 1};
    std::int32_t type = 0;
    std::int16_t good_ras = 1;
    std::array<float, 3> voxel{1, 1, 1};
    std::array<Vec3, 3> axes{Vec3{-1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}};
    Vec3 centre;
    std::string data = std::string(24, '\0');

    template <class Number, class Value>
    MghSample& numbers(std::int32_t kind, const std::vector<Value>& values)
    {
        type = kind;
        data.clear();
        for (const Value value : values)
        {
            append(data, static_cast<Number>(value), true);
        }
        return *this;
    }

    std::string bytes() const
    {
        std::string bytes;
        append(bytes, std::int32_t{1}, true);
        for (const std::int32_t length : size)
        {
            append(bytes, length, true);
        }
        append(bytes, type, true);
        append(bytes, std::int32_t{0}, true); // degrees of freedom
        append(bytes, good_ras, true);
        for (const float edge : voxel)
        {
            append(bytes, edge, true);
        }
        for (const Vec3& v : {axes[0], axes[1], axes[2], centre})
        {
            for (int row = 0; row < 3; ++row)
            {
                append(bytes, static_cast<float>(v[row]), true);
            }
        }
        bytes.resize(284, '\0');
        return bytes + data;
    }
};

} // namespace corticle
