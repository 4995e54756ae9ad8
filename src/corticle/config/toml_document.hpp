// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/value.hpp"

#include <optional>

namespace corticle
{

/// A section, or a key with its value, in the order of the file.
struct TomlEntry
{
    std::string key; ///< "section" or "section.key" (or "key", outside any section)
    std::string section;
    bool is_section = false;
    std::uint32_t line = 0;
    Value value;
};

/// Sections and keys of a TOML text. @throws InputError with the line, for text that is not TOML, too long or too deep.
std::vector<TomlEntry> parse_toml(std::string_view text, const std::string& name);

/// One value written as TOML; nothing where the text is no such value.
std::optional<Value> parse_toml_value(std::string_view text);

} // namespace corticle
