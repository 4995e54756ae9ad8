// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/toml_document.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// What the parts of a sweep file have in common.

namespace corticle::sweep
{

/// Where something stands: "sweep.toml:4".
struct SweepPlace
{
    const std::string& name; ///< of the file
    const std::filesystem::path& directory;

    std::string at(const config::TomlNode& node) const;
};

/// The text of a node. @param key  of the list that the node is in, for the message; else the node has its own
/// @throws InputError when it is none, empty, or has several lines
std::string sweep_text(const config::TomlNode& node, const SweepPlace& place, std::string_view key = {});

/// The number of a node. @param key  as for sweep_text
/// @throws InputError when it is none, or not finite
double sweep_number(const config::TomlNode& node, const SweepPlace& place, std::string_view key = {});

/// A value for a key of the case, checked against the table of parameters: file names become absolute, whole numbers
/// are given to keys that count.
/// @throws InputError
config::Value sweep_value(const std::string& key, const config::Value& value, const std::string& where,
                          const SweepPlace& place);

/// Keys of the case with their values, checked: of [set] and of a reference.
/// @throws InputError
std::vector<std::pair<std::string, config::Value>> case_values(const config::TomlNode& node, const SweepPlace& place);

} // namespace corticle::sweep
