// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/formats/inflating_stream.hpp"
#include "corticle/imaging/label_volume.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace corticle::formats
{

// The numbers are those of nifti1.h and nifti2.h (nifti.nimh.nih.gov).

enum class NiftiType : std::int16_t
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

/// Where a NIfTI file keeps what.
struct NiftiLayout
{
    std::size_t size;  ///< of the header [bytes]
    std::size_t magic; ///< the rest: offsets of the fields
    std::size_t dim, datatype, pixdim, vox_offset, scl_slope, scl_inter;
    std::size_t qform_code, sform_code, quaternion, offset, sform, units;
    bool wide; ///< NIfTI-2: 64-bit dimensions and numbers
};
inline constexpr NiftiLayout nifti1_layout{348, 344, 40, 70, 76, 108, 112, 116, 252, 254, 256, 268, 280, 123, false};
inline constexpr NiftiLayout nifti2_layout{540, 4, 16, 12, 104, 168, 176, 184, 344, 348, 352, 376, 400, 500, true};

/// What a label image needs of the header, checked.
struct NiftiHeader
{
    std::array<std::int64_t, 3> size{}; ///< voxels
    std::int64_t volumes = 1;
    NiftiType type = NiftiType::uint8;
    bool swapped = false; ///< the byte order is not this machine's
    double slope = 1.0;
    double intercept = 0.0;
    std::size_t skip = 0; ///< bytes between header and data
    imaging::VoxelFrame frame;
    std::vector<std::string> notes; ///< what was not taken as it stands, one line each
};

/// Reads the header and checks it. @throws InputError.
NiftiHeader read_nifti_header(InflatingStream& stream, const std::string& name, Coordinates coordinates);

/// Bytes of a number.
std::size_t size_of(NiftiType type);

/// A number from bytes, which may be in the other order.
template <class T>
T number_at(const char* bytes, bool swapped)
{
    std::array<char, sizeof(T)> copy{};
    for (std::size_t k = 0; k < sizeof(T); ++k)
    {
        copy[k] = bytes[swapped ? sizeof(T) - 1 - k : k];
    }
    return std::bit_cast<T>(copy);
}

} // namespace corticle::formats
