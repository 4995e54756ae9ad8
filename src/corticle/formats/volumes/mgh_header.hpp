// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/volume_header.hpp"

#include <string_view>

namespace corticle::formats
{

/// Do these four bytes begin FreeSurfer's format of volumes (.mgh, compressed .mgz)?
bool starts_mgh(std::string_view bytes);

/// Reads the header behind the first four bytes: 284 bytes, big endian; the voxels' frame is vox2ras, from the sizes
/// and directions of the axes and the centre of the volume (goodRASFlag = 1). @throws InputError
VolumeHeader read_mgh_header(InflatingStream& stream, const std::string& name);

} // namespace corticle::formats
