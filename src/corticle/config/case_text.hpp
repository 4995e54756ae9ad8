// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace corticle
{

/// The content of a case file. @throws InputError when it is missing, not a file, too long or unreadable.
std::string read_case_text(const std::filesystem::path& file);

} // namespace corticle
