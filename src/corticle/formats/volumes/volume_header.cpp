// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/volume_header.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/volumes/mgh_header.hpp"
#include "corticle/formats/volumes/nifti_header.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::formats
{

namespace
{

constexpr std::int64_t most_voxels = std::int64_t{1} << 31;
constexpr double smallest_voxel = 0.01; // [mm]
constexpr double largest_voxel = 20.0;  // [mm]

} // namespace

std::size_t size_of(NumberType type)
{
    using enum NumberType;
    switch (type)
    {
    case uint8:
    case int8:
        return 1;
    case int16:
    case uint16:
        return 2;
    case int32:
    case uint32:
    case float32:
        return 4;
    default:
        return 8;
    }
}

void add_axis(std::int64_t axis, std::int64_t length, std::int64_t& voxels, const std::string& name)
{
    if (length < 1 || length > most_voxels || (voxels *= length) > most_voxels)
    {
        fail_reading(name, fmt::format("absurd size along axis {}", axis), fmt::format("{}", length),
                     "1 or more voxels, not above 2^31 in all");
    }
}

void require_frame(const imaging::VoxelFrame& frame, const std::string& name, const std::string& field,
                   const std::string& remark)
{
    const Vec3 edges = imaging::voxel_edges(frame);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!(edges[axis] >= smallest_voxel && edges[axis] <= largest_voxel))
        {
            fail_reading(name, fmt::format("{}: absurd voxel size along axis {}", field, axis + 1),
                         fmt::format("{:.6g} mm{}", edges[axis], remark),
                         fmt::format("{:g} to {:g} mm", smallest_voxel, largest_voxel));
        }
    }
    constexpr double flattest = 1e-3; // volume of a voxel over that of one with right angles
    const double volume = std::abs(determinant(frame.linear));
    if (!(volume >= flattest * edges.x * edges.y * edges.z))
    {
        fail_reading(name, field + ": singular affine", fmt::format("voxels of {:.6g} mm³", volume),
                     "three edges that do not lie in a plane");
    }
    constexpr double farthest = 1e7; // [mm]
    if (!(norm(frame.origin) <= farthest))
    {
        fail_reading(
            name, field + ": absurd place of the first voxel",
            fmt::format("({:.6g}, {:.6g}, {:.6g}) mm{}", frame.origin.x, frame.origin.y, frame.origin.z, remark),
            "less than 10 km away");
    }
}

VolumeHeader read_volume_header(InflatingStream& stream, const std::string& name, Coordinates coordinates)
{
    std::array<char, 4> first{};
    const std::size_t there = stream.read(first.data(), first.size());
    const std::string_view start(first.data(), there);
    return starts_mgh(start) ? read_mgh_header(stream, name) : read_nifti_header(start, stream, name, coordinates);
}

} // namespace corticle::formats
