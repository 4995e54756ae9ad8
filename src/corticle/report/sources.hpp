// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/page.hpp"

namespace corticle::report
{

/// Whether a file or folder is there; one that cannot be looked at is not.
bool is_there(const std::filesystem::path& file);

/// A JSON file with an object in it. @throws InputError
Json read_json(const std::filesystem::path& file);

/// A path that results in a folder name: as it is given, from where the command stands, or from beside or within the
/// folder. @throws InputError when it is at none of these places
std::filesystem::path found_from(const std::filesystem::path& folder, const std::string& path);

} // namespace corticle::report
