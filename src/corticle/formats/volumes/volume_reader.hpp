// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/volume_numbers.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// What is taken from an image.
struct VolumeChoice
{
    std::optional<std::int64_t> volume;             ///< of a 4D image, from 0
    Coordinates coordinates = Coordinates::scanner; ///< file: xyzt_units is passed over, numbers are millimetres
    std::optional<double> threshold;                ///< a map of probabilities: label 1 from this value on, else 0
};

/// Reads tissue labels from a NIfTI-1 or -2 file of one piece or a pair, or from FreeSurfer's MGH and MGZ (told by
/// their first bytes, gzip-compressed or not), of either byte order, with integer or float numbers; scl_slope and
/// scl_inter are applied, and numbers that are whole but for round-off become labels. The frame of MGH is vox2ras, that
/// of NIfTI sform if sform_code > 0, else qform if qform_code > 0, else the voxel sizes alone, centred, x to the left
/// (as nibabel does); units of xyzt_units become millimetres. Fields outside the standard are taken as its reference
/// code and nibabel take them, and LabelVolume::notes says so: negative sizes by their absolute value, a quaternion
/// longer than 1 brought to that length, a qform in place of an sform of zeros. Never crashes, hangs or allocates more
/// than the file can justify.
/// @throws InputError, one line naming the file, when it is missing, truncated, not of these formats (ANALYZE 7.5 by
/// name), a 4D image without a choice of its volume, or holds absurd sizes or numbers that are not labels.
imaging::LabelVolume read_labels(const std::filesystem::path& file, const VolumeChoice& choice = {});

/// The same from bytes already in memory; `name` is used in messages. (What the fuzz test drives.)
imaging::LabelVolume parse_labels(const VolumeBytes& bytes, const std::string& name, const VolumeChoice& choice = {});

} // namespace corticle::formats
