// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_place.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace corticle::fit
{

/// A table of a fit or sensitivity file, member by member. All throw InputError of one line.
class TableReader
{
  public:
    /// @param what  of it in messages: "a parameter"
    /// @param known  the keys that it may have
    TableReader(const config::TomlNode& node, const sweep::SweepPlace& place, std::string what,
                std::span<const std::string_view> known);

    /// Null where it is not there.
    const config::TomlNode* find(std::string_view key) const;
    const config::TomlNode& at(std::string_view key) const;
    /// "fit.toml:4", of the table itself.
    std::string where() const { return place_.at(node_); }

    std::string text(std::string_view key) const { return sweep::sweep_text(at(key), place_); }
    std::string text(std::string_view key, const std::string& otherwise) const;
    double number(std::string_view key) const { return sweep::sweep_number(at(key), place_); }
    std::optional<double> number_if(std::string_view key) const;
    /// A number > 0.
    std::optional<double> positive_if(std::string_view key) const;
    /// A whole number of a range.
    std::int64_t count(std::string_view key, std::int64_t otherwise, std::int64_t low, std::int64_t high) const;

  private:
    const config::TomlNode& node_;
    const sweep::SweepPlace& place_;
    std::string what_;
};

/// The tables of a [[list]].
const std::vector<config::TomlNode>& tables_of(const config::TomlNode& node, const sweep::SweepPlace& place);

} // namespace corticle::fit
