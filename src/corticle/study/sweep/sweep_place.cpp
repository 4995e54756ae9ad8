// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_place.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::sweep
{

namespace
{

/// Leaves of tables within tables, as "section.key".
void collect_keys(const config::TomlNode& node, const std::string& prefix,
                  std::vector<std::pair<std::string, const config::TomlNode*>>& found)
{
    for (const config::TomlNode& child : node.children)
    {
        const std::string key = prefix.empty() ? child.key : prefix + "." + child.key;
        if (child.kind == config::TomlNode::Kind::table)
        {
            collect_keys(child, key, found);
        }
        else
        {
            found.emplace_back(key, &child);
        }
    }
}

} // namespace

std::string SweepPlace::at(const config::TomlNode& node) const
{
    return fmt::format("{}:{}", config::printable(name), node.line);
}

std::string sweep_text(const config::TomlNode& node, const SweepPlace& place, std::string_view key)
{
    const auto* text = std::get_if<std::string>(&node.value);
    if (text == nullptr || text->empty() || text->find_first_of(std::string_view("\0\n\r", 3)) != std::string::npos)
    {
        throw InputError(fmt::format(
            "{} ({}): got {}, expected a string{}", config::printable(key.empty() ? node.key : key), place.at(node),
            config::describe(node.value), text == nullptr ? "" : " that is a line and not empty"));
    }
    return *text;
}

double sweep_number(const config::TomlNode& node, const SweepPlace& place, std::string_view key)
{
    const auto* integer = std::get_if<std::int64_t>(&node.value);
    const auto* real = std::get_if<double>(&node.value);
    const double number = integer != nullptr ? static_cast<double>(*integer) : (real != nullptr ? *real : NAN);
    if (!std::isfinite(number))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a number",
                                     config::printable(key.empty() ? node.key : key), place.at(node),
                                     config::describe(node.value)));
    }
    return number;
}

config::Value sweep_value(const std::string& key, const config::Value& value, const std::string& where,
                          const SweepPlace& place)
{
    const config::Parameter* parameter = config::find_parameter(key);
    if (parameter == nullptr)
    {
        throw config::unknown_key_error(key, where);
    }
    config::Value typed = value;
    if (const auto* integer = std::get_if<std::int64_t>(&value);
        integer != nullptr && parameter->kind == config::Kind::real)
    {
        typed = static_cast<double>(*integer);
    }
    config::Options scratch;
    config::assign(scratch, *parameter, typed, where);
    const auto* text = std::get_if<std::string>(&typed);
    if (parameter->is_path && text != nullptr && !text->empty())
    {
        return std::filesystem::absolute(place.directory / *text).lexically_normal().string();
    }
    return typed;
}

std::vector<std::pair<std::string, config::Value>> case_values(const config::TomlNode& node, const SweepPlace& place)
{
    if (node.kind != config::TomlNode::Kind::table)
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a table of keys of the case",
                                     config::printable(node.key), place.at(node), config::describe(node.value)));
    }
    std::vector<std::pair<std::string, const config::TomlNode*>> found;
    collect_keys(node, "", found);
    std::vector<std::pair<std::string, config::Value>> values;
    for (const auto& [key, leaf] : found)
    {
        values.emplace_back(key, sweep_value(key, leaf->value, place.at(*leaf), place));
    }
    return values;
}

} // namespace corticle::sweep
