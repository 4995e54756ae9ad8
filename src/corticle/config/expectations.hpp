// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace corticle
{

/// The [expect] table of a case: for each key of summary.json the range [low, high] that its value is to lie in.
/// @throws InputError
std::map<std::string, std::array<double, 2>> read_expectations(const std::filesystem::path& file);

} // namespace corticle
