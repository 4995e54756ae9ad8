// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/mgh_header.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

constexpr std::size_t version_size = 4;
constexpr std::size_t header_size = 284; ///< where the data begin

/// The fields behind the version, by their offsets in the file.
class MghFields
{
  public:
    MghFields(InflatingStream& stream, const std::string& name)
    {
        const std::size_t there = stream.read(bytes_.data() + version_size, header_size - version_size);
        if (there < header_size - version_size)
        {
            fail_reading(name, "truncated in its header", fmt::format("{} bytes", version_size + there),
                         fmt::format("{} (MGH)", header_size));
        }
    }

    template <class Number>
    Number at(std::size_t offset) const
    {
        return load<Number>(&bytes_[offset], true);
    }
    Vec3 vector(std::size_t offset) const
    {
        return {static_cast<double>(at<float>(offset)), static_cast<double>(at<float>(offset + 4)),
                static_cast<double>(at<float>(offset + 8))};
    }

  private:
    std::array<char, header_size> bytes_{};
};

NumberType type_of(std::int32_t code, const std::string& name)
{
    switch (code)
    {
    case 0:
        return NumberType::uint8;
    case 1:
        return NumberType::int32;
    case 3:
        return NumberType::float32;
    case 4:
        return NumberType::int16;
    case 10:
        return NumberType::uint16;
    default:
        fail_reading(name, "numbers of a kind that MGH volumes are not read with", fmt::format("type {}", code),
                     "uchar (0), int (1), float (3), short (4) or ushort (10)");
    }
}

/// From the index of a voxel to the scanner: the middle of the volume is c_ras.
imaging::VoxelFrame frame_of(const MghFields& fields, VolumeHeader& header, const std::string& name)
{
    constexpr std::size_t good_ras = 28;
    constexpr std::size_t sizes = 30;
    constexpr std::size_t directions = 42;
    constexpr std::size_t centre = 78;
    const Vec3 middle = 0.5 * Vec3{static_cast<double>(header.size[0]), static_cast<double>(header.size[1]),
                                   static_cast<double>(header.size[2])};
    imaging::VoxelFrame frame{{{Vec3{-1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, {}}; // FreeSurfer's own default
    Vec3 c_ras;
    if (fields.at<std::int16_t>(good_ras) > 0)
    {
        const Vec3 size = fields.vector(sizes);
        for (int axis = 0; axis < 3; ++axis)
        {
            frame.linear.column[axis] = size[axis] * fields.vector(directions + 12 * static_cast<std::size_t>(axis));
        }
        c_ras = fields.vector(centre);
    }
    else
    {
        header.notes.emplace_back("the header does not say where its voxels lie (goodRASFlag is 0): taken as "
                                  "FreeSurfer does, 1 mm, centred, first axis to the left, so left and right are a "
                                  "guess");
    }
    frame.origin = c_ras - frame.linear * middle;
    require_frame(frame, name, "vox2ras", "");
    return frame;
}

} // namespace

bool starts_mgh(std::string_view bytes)
{
    return bytes == std::string_view("\0\0\0\1", version_size);
}

VolumeHeader read_mgh_header(InflatingStream& stream, const std::string& name)
{
    const MghFields fields(stream, name);
    VolumeHeader header;
    header.big_endian = true;
    std::int64_t voxels = 1;
    for (std::int64_t axis = 1; axis <= 4; ++axis)
    {
        const std::int64_t length = fields.at<std::int32_t>(4 * static_cast<std::size_t>(axis));
        add_axis(axis, length, voxels, name);
        (axis <= 3 ? header.size[static_cast<std::size_t>(axis) - 1] : header.volumes) = length;
    }
    constexpr std::size_t type = 20;
    header.type = type_of(fields.at<std::int32_t>(type), name);
    header.frame = frame_of(fields, header, name);
    return header;
}

} // namespace corticle::formats
