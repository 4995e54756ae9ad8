// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::formats
{

/// The other file of a pair, .img for .hdr and .hdr for .img; empty where there is none.
std::filesystem::path other_of_pair(const std::filesystem::path& file);

/// Files that are read with this one: the other of a pair (.hdr, .img), and those that hold the numbers of a GIFTI.
/// Empty where the file cannot be read.
std::vector<std::filesystem::path> companion_files(const std::filesystem::path& file);

/// SHA-256 of a file, or of those of it and its companions where it has any; empty where one cannot be read.
std::string sha256_with_companions(const std::filesystem::path& file);

} // namespace corticle::formats
