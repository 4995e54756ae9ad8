// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace corticle::record
{

/// All that a run needs, besides its case, to go on to the same bits.
struct Checkpoint
{
    std::string program_version;                      ///< or versions, the one that wrote it last
    std::string case_text;                            ///< the resolved case, TOML
    std::map<std::string, std::vector<Vec3>> vectors; ///< for instance "position", "velocity"
    std::map<std::string, std::vector<double>> scalars;
    std::map<std::string, std::vector<std::int64_t>> integers;
};

/// Writes checkpoint.h5 (HDF5), whole or not at all: an earlier checkpoint stays until the new one is complete on disk.
/// @throws RunError naming the file and the reason (disk full, no permission).
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// @throws InputError, one line naming the file, when it is missing, truncated, damaged (a checksum over all data is
/// kept) or not one of ours.
Checkpoint read_checkpoint(const std::filesystem::path& file);

} // namespace corticle::record
