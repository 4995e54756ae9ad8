// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// SHA-256 of a file's bytes, 64 hexadecimal digits, as `sha256sum` prints it; empty where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// The same of a text.
std::string sha256_of_text(std::string_view text);

} // namespace corticle::formats
