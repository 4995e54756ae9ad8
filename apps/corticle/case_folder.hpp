// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace corticle
{

/// Where the results of a case go: `out`, or without it PARENT/<stem of the case>.
/// @throws InputError where neither says, as the case comes from the standard input
std::filesystem::path chosen_folder(const std::filesystem::path& out, const char* parent,
                                    const std::filesystem::path& case_file);

} // namespace corticle
