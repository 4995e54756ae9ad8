// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/words.hpp"

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

// Pages and pictures use the same words.
using view::label_of;
using view::unit_text;

} // namespace corticle::report
