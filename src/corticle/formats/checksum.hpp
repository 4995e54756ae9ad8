// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// 64 bits over all bytes, eight at a time: FNV-1a on words with a final avalanche. Tells what was damaged, not what
/// was forged.
std::uint64_t checksum(std::string_view bytes);

/// A comment of XML with the checksum of all that stands before it, for the end of files of this program.
std::string checksum_line(std::string_view bytes);

/// Appends that line to a file.
/// @param name  as errors call the file
/// @throws RunError with the reason when it cannot be written
void append_checksum(const std::filesystem::path& file, const std::string& name);

/// Where a file ends in such a line, its bytes must be those it was made of; a file without one is not judged.
/// @throws InputError naming the file
void require_checksum(std::string_view bytes, const std::string& name);

} // namespace corticle::formats
