// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/value.hpp"

#include <optional>

namespace corticle::config
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

/// A value, table or list of a TOML text with what it holds.
struct TomlNode
{
    enum class Kind
    {
        value,
        table,
        list
    };
    std::string key; ///< within its table; empty in a list and at the top
    std::uint32_t line = 0;
    Kind kind = Kind::value;
    Value value;                    ///< also of a list, where a case can hold it; else Unsupported
    std::vector<TomlNode> children; ///< of a table in the order of the file, of a list in its own
};

/// A whole TOML text, as its topmost table. `what` ("case") is used in messages.
/// @throws InputError with the line, for text that is not TOML, too long or too deep.
TomlNode parse_toml_tree(std::string_view text, const std::string& name, std::string_view what);

/// Sections and keys of a TOML text. @throws InputError with the line, for text that is not TOML, too long or too deep.
std::vector<TomlEntry> parse_toml(std::string_view text, const std::string& name);

/// One value written as TOML; nothing where the text is not such a value.
std::optional<Value> parse_toml_value(std::string_view text);

} // namespace corticle::config
