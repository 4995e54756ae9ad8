// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/options.hpp"
#include "corticle/config/parameters/value.hpp"

#include <array>
#include <functional>
#include <limits>
#include <span>

// The one table of parameters: parsing, messages, resolved cases and the schema derive from it.

namespace corticle::config
{

inline constexpr std::int64_t fewest_elements = 2500;
inline constexpr std::int64_t most_elements = 500'000'000;

/// Numbers between two bounds, each with or without the bound itself.
struct Range
{
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;

    bool contains(double value) const;
    std::string text() const; ///< "> 0", ">= 1", "(0, 1]", or "" without bounds
};

enum class Kind
{
    boolean,
    integer,
    real,
    text,
    choice,
    list,    ///< of increasing numbers, or of a fixed number of them
    integers ///< a list of integers in any order
};

/// What a user may set.
struct Parameter
{
    std::string key; ///< "section.key"
    Kind kind = Kind::real;
    std::string unit;
    Range range;                      ///< of numbers, and of each number of a list
    std::vector<std::string> choices; ///< of Kind::choice
    std::size_t length = 0;           ///< of a list; 0: any length
    bool any_order = false;           ///< of a list of any length: its numbers need not increase
    bool is_path = false;             ///< a text that names a file, relative to the case
    std::string sentence;
    std::string example;                      ///< a valid value as TOML, of a key without a default
    std::function<Value(const Options&)> get; ///< Unsupported where an optional is not given
    std::function<void(Options&, const Value&)> set;

    bool of_list = false; ///< of an element of a list of tables: "support.2.kind" of the second [[support]]

    std::string section() const { return key.substr(0, key.find('.')); }
    /// What comes before the name: the section, and of a list of tables which of them.
    std::string table() const { return of_list ? key.substr(0, key.rfind('.')) : section(); }
    std::string name() const { return key.substr(table().size() + 1); }
    /// How its table is written in a case.
    std::string heading() const;
    /// Whether it repeats the parameter of an earlier element of the list.
    bool repeats() const;
    std::string kind_text() const;     ///< "number", "list of 3 numbers", ...
    std::string expected_text() const; ///< kind, range and unit
};

/// Every parameter, in the order of sections and keys of a resolved case.
std::span<const Parameter> parameters();

/// Null when there is none of this key.
const Parameter* find_parameter(std::string_view key);

/// The valid key that `key` was probably meant to be; empty when none is near.
std::string nearest_key(std::string_view key);
/// What to throw where there is no such key; `where` ("case.toml:4", "--set a.b=c") is used in the message.
InputError unknown_key_error(std::string_view key, const std::string& where);
/// The valid section that `section` was probably meant to be; empty when none is near.
std::string nearest_section(std::string_view section);

/// Options of an empty case.
Options default_options();

/// Gives the parameter this value; `where` ("case.toml:4", "--set a.b=c") is used in the message.
/// @throws InputError for a wrong type, a number out of range or not finite, an unknown choice.
void assign(Options& options, const Parameter& parameter, const Value& value, const std::string& where);

} // namespace corticle::config
