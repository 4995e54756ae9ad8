// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/config/parameters/value.hpp"

#include <span>
#include <string_view>

namespace corticle::config
{

/// Reads a case (TOML; - is the standard input) and then `overrides` ("section.key=value"); checks every key, type and
/// range. `base_directory` resolves relative paths. An [expect] table is allowed and ignored here.
/// @throws InputError, one line: what, where (file and line, or --set), got, expected, nearest valid key.
Options read_case(const std::filesystem::path& file, std::span<const std::string> overrides);

/// The same from text; `name` is used in messages. (What the fuzz test drives.)
Options parse_case(std::string_view text, const std::string& name, std::span<const std::string> overrides,
                   const std::filesystem::path& base_directory);

/// A value that replaces what a case says of a key.
struct Override
{
    std::string key; ///< "section.key"
    Value value;
    std::string where; ///< for messages: "--set geometry.particles=3"
};
/// parse_case with values as a program has them.
Options parse_overridden_case(std::string_view text, const std::string& name, std::span<const Override> overrides,
                              const std::filesystem::path& base_directory);

/// The resolved case as TOML, every key with its value: what the run folder's case.toml and the checkpoint hold.
/// read_case of it gives equal options. Ends with the checksums of Options::inputs, as an [inputs] table.
std::string to_toml(const Options& options);

/// Keys that differ between two resolved cases, apart from those that may change on resuming (output.*, time.end):
/// "section.key: a -> b". Files are compared by content where both cases give checksums, else by name.
std::vector<std::string> differing_keys(std::string_view resolved_a, std::string_view resolved_b);

/// The same for the keys that an arranged body depends on: those of [geometry] and [map].
std::vector<std::string> differing_body_keys(std::string_view resolved_a, std::string_view resolved_b);

/// Every key with type, unit, default, range and sentence: for `corticle schema` (text) and the docs page (Markdown).
std::string schema_text();
std::string schema_markdown();

} // namespace corticle::config
