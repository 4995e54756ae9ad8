// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::report
{

/// The text with every path of the machine cut down to the name of its file: a page that is sent to others tells
/// nothing of the folders it comes from.
std::string without_paths(std::string_view text);

/// The last part of a path, whether it ends in a slash or not.
std::string name_of(const std::filesystem::path& path);

/// A key in words: "sulcal_depth_mean_mm" is "sulcal depth, mean".
std::string label_of(std::string_view key);

/// A unit as people write it: "mm2" is "mm²", "-" is nothing.
std::string unit_text(std::string_view unit);

} // namespace corticle::report
