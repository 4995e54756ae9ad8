// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/nifti_fields.hpp"

namespace corticle::formats
{

/// Where the voxels of an image lie, checked: see read_nifti. `notes` receives a line for each field that was not taken
/// as it stands. @throws InputError that names the field: sform, qform, pixdim or xyzt_units
imaging::VoxelFrame read_nifti_frame(const NiftiFields& fields, const std::array<std::int64_t, 3>& size,
                                     Coordinates coordinates, std::vector<std::string>& notes);

} // namespace corticle::formats
