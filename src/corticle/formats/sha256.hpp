// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace corticle::formats
{

/// SHA-256 of a file's bytes, 64 hexadecimal digits, as `sha256sum` prints it; empty where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

} // namespace corticle::formats
