// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/checkpoint.hpp"

#include <string>
#include <string_view>

namespace corticle::record
{

/// Appends the HDF5 file that holds a checkpoint to `bytes`; false when HDF5 fails.
bool append_checkpoint_image(const Checkpoint& checkpoint, std::string& bytes);

/// Reads such a file back; false when HDF5 fails or something is missing.
bool parse_checkpoint_image(std::string_view image, Checkpoint& checkpoint);

} // namespace corticle::record
