// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace corticle::config
{

/// Not given, or something that no parameter takes (a date, a table, a list of strings): `what` says it.
struct Unsupported
{
    std::string what;
};

/// A value as written in a case.
using Value = std::variant<Unsupported, bool, std::int64_t, double, std::string, std::vector<double>>;

/// As TOML, shortest text that reads back to the same value; empty for Unsupported.
std::string toml_text(const Value& value);

/// For messages: kind and value, shortened, on one line.
std::string describe(const Value& value);

/// `text` shortened and without control characters, fit for a one-line message.
std::string printable(std::string_view text, std::size_t longest = 120);

} // namespace corticle::config
