// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/volume_header.hpp"

#include <string_view>

namespace corticle::formats
{

// The numbers are those of nifti1.h and nifti2.h (nifti.nimh.nih.gov).

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

/// Reads the header whose first four bytes are `start`, and checks it. @throws InputError.
VolumeHeader read_nifti_header(std::string_view start, InflatingStream& stream, const std::string& name,
                               Coordinates coordinates);

} // namespace corticle::formats
