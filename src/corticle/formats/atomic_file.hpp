// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Calls `write(path)` with a temporary name beside `file`, flushes what it wrote to disk and renames it to `file`:
/// the file appears whole or not at all. On failure the temporary is removed and RunError names the file and the
/// reason.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path&)>& write);

/// The same for text already in memory.
void write_text_atomically(const std::filesystem::path& file, std::string_view text);

/// The name of the file that a temporary of this name was to become; empty for names of no temporary.
std::string target_of_temporary(std::string_view name);

/// Flushes the names of all files in a folder, which are else up to the system: after a power cut a file may be missing
/// that was written. Some file systems refuse; nothing is lost but that certainty.
void flush_names(const std::filesystem::path& folder);

} // namespace corticle::formats
