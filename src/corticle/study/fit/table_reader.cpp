// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/table_reader.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace corticle::fit
{

TableReader::TableReader(const config::TomlNode& node, const sweep::SweepPlace& place, std::string what,
                         std::span<const std::string_view> known)
    : node_(node), place_(place), what_(std::move(what))
{
    if (node.kind != config::TomlNode::Kind::table)
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a table", config::printable(node.key), place.at(node),
                                     config::describe(node.value)));
    }
    for (const config::TomlNode& child : node.children)
    {
        if (std::ranges::find(known, child.key) == known.end())
        {
            throw InputError(fmt::format("unknown key {} of {} ({}); expected {}", config::printable(child.key), what_,
                                         place.at(child), fmt::join(known, ", ")));
        }
    }
}

const config::TomlNode* TableReader::find(std::string_view key) const
{
    const auto found = std::ranges::find(node_.children, key, &config::TomlNode::key);
    return found == node_.children.end() ? nullptr : &*found;
}

const config::TomlNode& TableReader::at(std::string_view key) const
{
    const config::TomlNode* found = find(key);
    if (found == nullptr)
    {
        throw InputError(fmt::format("{} without {} ({}); expected it", what_, key, where()));
    }
    return *found;
}

std::string TableReader::text(std::string_view key, const std::string& otherwise) const
{
    const config::TomlNode* found = find(key);
    return found == nullptr ? otherwise : sweep::sweep_text(*found, place_);
}

std::optional<double> TableReader::number_if(std::string_view key) const
{
    const config::TomlNode* found = find(key);
    return found == nullptr ? std::nullopt : std::optional(sweep::sweep_number(*found, place_));
}

std::optional<double> TableReader::positive_if(std::string_view key) const
{
    const std::optional<double> number = number_if(key);
    if (number && !(*number > 0.0))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a number > 0", key, place_.at(at(key)), *number));
    }
    return number;
}

std::int64_t TableReader::count(std::string_view key, std::int64_t otherwise, std::int64_t low, std::int64_t high) const
{
    const config::TomlNode* found = find(key);
    if (found == nullptr)
    {
        return otherwise;
    }
    const auto* integer = std::get_if<std::int64_t>(&found->value);
    if (integer == nullptr || *integer < low || *integer > high)
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a whole number from {} to {}", key, place_.at(*found),
                                     config::describe(found->value), low, high));
    }
    return *integer;
}

const std::vector<config::TomlNode>& tables_of(const config::TomlNode& node, const sweep::SweepPlace& place)
{
    const auto is_table = [](const config::TomlNode& child) { return child.kind == config::TomlNode::Kind::table; };
    if (node.kind != config::TomlNode::Kind::list || !std::ranges::all_of(node.children, is_table))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected tables: [[{}]]", config::printable(node.key),
                                     place.at(node), config::describe(node.value), config::printable(node.key)));
    }
    return node.children;
}

} // namespace corticle::fit
