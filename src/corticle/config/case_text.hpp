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

} // namespace corticle::config
