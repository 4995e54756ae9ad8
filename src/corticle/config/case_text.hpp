// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::config
{

/// The content of a case file, or of another file that the user writes; `what` is used in messages.
/// @throws InputError when it is missing, not a file, too long or unreadable.
std::string read_case_text(const std::filesystem::path& file, std::string_view what = "case");

/// Is the case to be read from the standard input: "-"?
bool is_standard_input(const std::filesystem::path& file);
/// The case on the standard input. @throws InputError when it is too long or unreadable.
std::string read_standard_input();

} // namespace corticle::config
