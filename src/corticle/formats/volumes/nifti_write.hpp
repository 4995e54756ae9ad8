// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <filesystem>

namespace corticle::formats
{

/// Writes NIfTI-1 in the smallest integer type that holds the labels; `.nii.gz` is compressed, `.nii` is not. sform
/// carries the frame, and qform too where its voxels have right angles. Appears whole or not at all.
/// @throws InputError for another extension or an image too large for NIfTI-1; RunError when it cannot be written.
void write_nifti(const std::filesystem::path& file, const imaging::LabelVolume& image);

} // namespace corticle::formats
