// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/formats/inflating_stream.hpp"
#include "corticle/imaging/label_volume.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace corticle::formats
{

/// Kinds of numbers, by the codes of nifti1.h.
enum class NumberType : std::int16_t
{
    uint8 = 2,
    int16 = 4,
    int32 = 8,
    float32 = 16,
    float64 = 64,
    int8 = 256,
    uint16 = 512,
    uint32 = 768,
    int64 = 1024,
    uint64 = 1280
};

/// Bytes of a number.
std::size_t size_of(NumberType type);

/// What is needed of the header of an image of any format, checked.
struct VolumeHeader
{
    std::array<std::int64_t, 3> size{}; ///< voxels
    std::int64_t volumes = 1;
    NumberType type = NumberType::uint8;
    bool big_endian = false;
    bool is_pair = false; ///< the numbers are in a file of their own
    double slope = 1.0;
    double intercept = 0.0;
    std::size_t skip = 0; ///< bytes before the data
    imaging::VoxelFrame frame;
    std::vector<std::string> notes; ///< what was not taken as it stands, one line each

    std::size_t voxels() const { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }
};

/// Multiplies the number of voxels by the length of an axis, counted from 1. @throws InputError for absurd ones
void add_axis(std::int64_t axis, std::int64_t length, std::int64_t& voxels, const std::string& name);

/// @param field   of the header that the frame is from
/// @param remark  for messages, on the unit of length
/// @throws InputError for absurd or flat voxels
void require_frame(const imaging::VoxelFrame& frame, const std::string& name, const std::string& field,
                   const std::string& remark);

/// Reads the header of an image of any format, told by its first bytes, and checks it. @throws InputError
VolumeHeader read_volume_header(InflatingStream& stream, const std::string& name, Coordinates coordinates);

} // namespace corticle::formats
