// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/toml_document.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

namespace corticle::config
{

namespace
{

constexpr std::size_t longest_text = 1 << 20;
constexpr std::size_t most_key_dots = 2000;

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/// Dots that may join keys: all but those between the digits of one number. They bound how deep tables nest, which
/// matters because the tables of the parser are freed recursively; brackets are bounded by the parser itself.
std::size_t count_key_dots(std::string_view text)
{
    std::size_t dots = 0;
    bool number = false; // one dot between digits already seen in this word
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (c == '.')
        {
            const bool between = i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
            dots += between && !number ? 0 : 1;
            number = true;
        }
        else if (c == ' ' || c == ',' || c == '\n' || c == '\t' || c == '[' || c == ']')
        {
            number = false;
        }
    }
    return dots;
}

std::optional<double> number_of(const toml::node& node)
{
    if (const auto* real = node.as_floating_point())
    {
        return real->get();
    }
    if (const auto* integer = node.as_integer())
    {
        return static_cast<double>(integer->get());
    }
    return std::nullopt;
}

Value list_value(const toml::array& list)
{
    std::vector<double> numbers;
    numbers.reserve(list.size());
    for (const toml::node& element : list)
    {
        const std::optional<double> number = number_of(element);
        if (!number)
        {
            return Unsupported{element.is_table() ? "a list of tables" : "a list of other things than numbers"};
        }
        numbers.push_back(*number);
    }
    return numbers;
}

Value value_of(const toml::node& node)
{
    if (const auto* flag = node.as_boolean())
    {
        return flag->get();
    }
    if (const auto* integer = node.as_integer())
    {
        return integer->get();
    }
    if (const auto* real = node.as_floating_point())
    {
        return real->get();
    }
    if (const auto* text = node.as_string())
    {
        return text->get();
    }
    if (const auto* list = node.as_array())
    {
        return list_value(*list);
    }
    return Unsupported{node.is_table() ? "a table" : "a date or time"};
}

TomlNode tree_of(const toml::node& node)
{
    TomlNode result{"", node.source().begin.line, TomlNode::Kind::value, value_of(node), {}};
    if (const auto* table = node.as_table())
    {
        result.kind = TomlNode::Kind::table;
        for (auto&& [key, child] : *table)
        {
            result.children.push_back(tree_of(child));
            result.children.back().key = key.str();
            result.children.back().line = key.source().begin.line;
        }
        std::ranges::stable_sort(result.children, {}, &TomlNode::line);
    }
    if (const auto* list = node.as_array())
    {
        result.kind = TomlNode::Kind::list;
        for (const toml::node& child : *list)
        {
            result.children.push_back(tree_of(child));
        }
    }
    return result;
}

} // namespace

TomlNode parse_toml_tree(std::string_view text, const std::string& name, std::string_view what)
{
    if (text.size() > longest_text)
    {
        throw InputError(fmt::format("{} is no {}: got {} bytes, expected at most {}", printable(name), what,
                                     text.size(), longest_text));
    }
    if (count_key_dots(text) > most_key_dots)
    {
        throw InputError(fmt::format("{} is no {}: its keys nest too deep (more than {} dots)", printable(name), what,
                                     most_key_dots));
    }
    try
    {
        return tree_of(toml::parse(text));
    }
    catch (const toml::parse_error& error)
    {
        throw InputError(fmt::format("{}:{}: not TOML: {}", printable(name), error.source().begin.line,
                                     printable(error.description(), 200)));
    }
}

namespace
{

/// Whether keys of cases begin with this one: that of a table in a section, as in [tissue.labels].
bool is_group(const std::string& key)
{
    return std::ranges::any_of(parameters(), [&](const Parameter& p) { return p.key.starts_with(key + "."); });
}

/// As [[support]] is.
bool is_list_of_tables(const TomlNode& node)
{
    return node.kind == TomlNode::Kind::list && !node.children.empty() && is_group(node.key + ".1") &&
           std::ranges::all_of(node.children,
                               [](const TomlNode& child) { return child.kind == TomlNode::Kind::table; });
}

/// The keys of the second [[support]] are support.2.kind and so on.
void add_list_of_tables(TomlNode& node, const std::string& name, std::vector<TomlEntry>& entries)
{
    for (std::size_t k = 0; k < node.children.size(); ++k)
    {
        if (!is_group(fmt::format("{}.{}", node.key, k + 1)))
        {
            throw InputError(fmt::format("{}:{}: got {} tables [[{}]], expected at most {}", printable(name),
                                         node.children[k].line, node.children.size(), node.key, k));
        }
        entries.push_back({node.key, node.key, true, node.children[k].line, Unsupported{"a table"}});
        for (TomlNode& child : node.children[k].children)
        {
            entries.push_back({fmt::format("{}.{}.{}", node.key, k + 1, child.key), node.key, false, child.line,
                               std::move(child.value)});
        }
    }
}

} // namespace

std::vector<TomlEntry> parse_toml(std::string_view text, const std::string& name)
{
    std::vector<TomlEntry> entries;
    for (TomlNode& node : parse_toml_tree(text, name, "case").children)
    {
        if (is_list_of_tables(node))
        {
            add_list_of_tables(node, name, entries);
            continue;
        }
        if (node.kind != TomlNode::Kind::table)
        {
            entries.push_back({node.key, "", false, node.line, std::move(node.value)});
            continue;
        }
        entries.push_back({node.key, node.key, true, node.line, Unsupported{"a table"}});
        for (TomlNode& child : node.children)
        {
            const std::string key = node.key + "." + child.key;
            if (child.kind == TomlNode::Kind::table && is_group(key))
            {
                for (TomlNode& grandchild : child.children)
                {
                    entries.push_back(
                        {key + "." + grandchild.key, node.key, false, grandchild.line, std::move(grandchild.value)});
                }
                continue;
            }
            entries.push_back({node.key + "." + child.key, node.key, false, child.line, std::move(child.value)});
        }
    }
    std::ranges::stable_sort(entries, {}, &TomlEntry::line);
    return entries;
}

std::optional<Value> parse_toml_value(std::string_view text)
{
    if (text.size() > longest_text || text.find_first_of("\r\n") != std::string_view::npos ||
        count_key_dots(text) > most_key_dots)
    {
        return std::nullopt;
    }
    try
    {
        const toml::table document = toml::parse("value = " + std::string(text));
        return value_of(*document.get("value"));
    }
    catch (const toml::parse_error&)
    {
        return std::nullopt;
    }
}

} // namespace corticle::config
