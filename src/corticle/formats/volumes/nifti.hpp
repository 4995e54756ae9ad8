// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/imaging/label_volume.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Is this, by its name in either case, a NIfTI file: .nii, .nii.gz, or the .hdr and .img of the older pairs?
bool is_nifti(const std::filesystem::path& file);

/// What is taken from a NIfTI file.
struct NiftiChoice
{
    std::optional<std::int64_t> volume;             ///< of a 4D image, from 0
    Coordinates coordinates = Coordinates::scanner; ///< file: xyzt_units is passed over, numbers are millimetres
};

/// Reads tissue labels from a NIfTI-1 or NIfTI-2 file of one piece (`.nii`, or gzip-compressed, whatever its name), of
/// either byte order, with integer or float numbers; scl_slope and scl_inter are applied, and numbers that are whole
/// but for round-off become labels. The frame is that of sform if sform_code > 0, else of qform if qform_code > 0, else
/// the voxel sizes alone, centred, x to the left (as nibabel does); units of xyzt_units become millimetres. Fields
/// outside the standard are taken as its reference code and nibabel take them, and LabelVolume::notes says so:
/// negative sizes by their absolute value, a quaternion longer than 1 brought to that length, a qform in place of an
/// sform of zeros. Never crashes, hangs or allocates more than the file can justify.
/// @throws InputError, one line naming the file, when it is missing, truncated, not of this format, a 4D image without
/// a choice of its volume, or holds absurd sizes or numbers that are not labels.
imaging::LabelVolume read_nifti(const std::filesystem::path& file, const NiftiChoice& choice = {});

/// The same from bytes already in memory; `name` is used in messages. (What the fuzz test drives.)
imaging::LabelVolume parse_nifti(std::string_view bytes, const std::string& name, const NiftiChoice& choice = {});

/// Writes NIfTI-1 in the smallest integer type that holds the labels; `.nii.gz` is compressed, `.nii` is not. sform
/// carries the frame, and qform too where its voxels have right angles. Appears whole or not at all.
/// @throws InputError for another extension or an image too large for NIfTI-1; RunError when it cannot be written.
void write_nifti(const std::filesystem::path& file, const imaging::LabelVolume& image);

} // namespace corticle::formats
