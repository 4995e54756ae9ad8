// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Throws InputError "FILE: what; got ...; expected ...", always one line: bytes that do not print become '?'
/// and a long `got` is cut.
[[noreturn]] void fail_reading(std::string_view file, std::string_view what, std::string_view got,
                               std::string_view expected);

/// The whole of a file, up to 4 GiB. @throws InputError, one line, when it is missing, a directory, too large or cannot
/// be read.
std::string read_whole_file(const std::filesystem::path& file);

/// Without its dot; empty when there is none.
std::string lower_case_extension(const std::filesystem::path& file);

} // namespace corticle::formats
