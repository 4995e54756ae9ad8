// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/parameters.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace corticle::config
{

namespace
{

constexpr std::size_t longest_list = 10000;
constexpr std::size_t longest_name = 64; // of a key worth a suggestion

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

std::string_view last_part(std::string_view key)
{
    return key.substr(key.rfind('.') + 1);
}

bool is_whole_list(const Value& value)
{
    const auto* list = std::get_if<std::vector<double>>(&value);
    return list != nullptr && std::ranges::all_of(*list, [](double number) { return number == std::round(number); });
}

/// The value in the type the parameter keeps (an integer where a number is expected becomes a number).
/// Unsupported when the type is wrong.
Value converted(const Parameter& parameter, const Value& value)
{
    switch (parameter.kind)
    {
    case Kind::boolean:
        return std::holds_alternative<bool>(value) ? value : Unsupported{};
    case Kind::integer:
        return std::holds_alternative<std::int64_t>(value) ? value : Unsupported{};
    case Kind::real:
        if (const auto* integer = std::get_if<std::int64_t>(&value))
        {
            return static_cast<double>(*integer);
        }
        return std::holds_alternative<double>(value) ? value : Unsupported{};
    case Kind::text:
    case Kind::choice:
        return std::holds_alternative<std::string>(value) ? value : Unsupported{};
    case Kind::list:
        return std::holds_alternative<std::vector<double>>(value) ? value : Unsupported{};
    case Kind::integers:
        return is_whole_list(value) ? value : Unsupported{};
    }
    return Unsupported{};
}

bool list_in_range(const Parameter& parameter, const std::vector<double>& list)
{
    const bool fixed = parameter.length > 0;
    return (fixed ? list.size() == parameter.length : list.size() <= longest_list) &&
           std::ranges::all_of(list, [&](double value) { return parameter.range.contains(value); }) &&
           (fixed || parameter.any_order || parameter.kind == Kind::integers ||
            std::ranges::adjacent_find(list, std::greater_equal<>{}) == list.end());
}

bool in_range(const Parameter& parameter, const Value& value)
{
    if (const auto* integer = std::get_if<std::int64_t>(&value))
    {
        return parameter.range.contains(static_cast<double>(*integer));
    }
    if (const auto* real = std::get_if<double>(&value))
    {
        return parameter.range.contains(*real);
    }
    if (const auto* list = std::get_if<std::vector<double>>(&value))
    {
        return list_in_range(parameter, *list);
    }
    if (const auto* text = std::get_if<std::string>(&value))
    {
        return parameter.kind != Kind::choice || std::ranges::find(parameter.choices, *text) != parameter.choices.end();
    }
    return true;
}

} // namespace

bool Range::contains(double value) const
{
    return std::isfinite(value) && (low_open ? value > low : value >= low) && value <= high;
}

std::string Range::text() const
{
    if (std::isinf(low) && std::isinf(high))
    {
        return "";
    }
    if (std::isinf(high))
    {
        return fmt::format("{} {}", low_open ? ">" : ">=", low);
    }
    return fmt::format("{}{:.12g}, {:.12g}]", low_open ? '(' : '[', low, high);
}

std::string Parameter::heading() const
{
    return fmt::format(fmt::runtime(of_list ? "[[{}]]" : "[{}]"), section());
}

bool Parameter::repeats() const
{
    return of_list && !key.starts_with(section() + ".1.");
}

std::string Parameter::kind_text() const
{
    switch (kind)
    {
    case Kind::boolean:
        return "true or false";
    case Kind::integer:
        return "an integer";
    case Kind::real:
        return "a number";
    case Kind::text:
        return "a string";
    case Kind::choice:
        return fmt::format("\"{}\"", fmt::join(choices, "\" or \""));
    case Kind::list:
        return length > 0  ? fmt::format("a list of {} numbers", length)
               : any_order ? "a list of numbers"
                           : "a list of increasing numbers";
    case Kind::integers:
        return "a list of integers";
    }
    return "";
}

std::string Parameter::expected_text() const
{
    const std::string bounds = range.text();
    return kind_text() + (bounds.empty() ? "" : (bounds.front() == '>' ? " " : " in ") + bounds) +
           (unit.empty() ? "" : " " + unit);
}

const Parameter* find_parameter(std::string_view key)
{
    const auto all = parameters();
    const auto found = std::ranges::find(all, key, &Parameter::key);
    return found == all.end() ? nullptr : &*found;
}

std::string nearest_key(std::string_view key)
{
    if (key.size() > longest_name)
    {
        return "";
    }
    std::string nearest;
    std::size_t least = 2 + last_part(key).size() / 3;
    for (const Parameter& parameter : parameters())
    {
        // A right name in a wrong section counts as one error.
        const std::size_t distance =
            std::min(edit_distance(key, parameter.key), 1 + edit_distance(last_part(key), last_part(parameter.key)));
        if (distance < least)
        {
            least = distance;
            nearest = parameter.key;
        }
    }
    return nearest;
}

InputError unknown_key_error(std::string_view key, const std::string& where)
{
    const std::string nearest = nearest_key(key);
    return InputError(
        fmt::format("unknown key {} ({}); {}", printable(key), where,
                    nearest.empty() ? "`corticle schema` lists the valid keys" : "did you mean " + nearest + "?"));
}

std::string nearest_section(std::string_view section)
{
    if (section.size() > longest_name)
    {
        return "";
    }
    std::string nearest;
    std::size_t least = 2 + section.size() / 3;
    for (const Parameter& parameter : parameters())
    {
        const std::size_t distance = edit_distance(section, parameter.section());
        if (distance < least)
        {
            least = distance;
            nearest = parameter.section();
        }
    }
    return nearest;
}

void assign(Options& options, const Parameter& parameter, const Value& value, const std::string& where)
{
    const Value typed = converted(parameter, value);
    const bool wrong_type = std::holds_alternative<Unsupported>(typed);
    if (wrong_type || !in_range(parameter, typed))
    {
        throw InputError(fmt::format("{} {} ({}): got {}, expected {}", parameter.key,
                                     wrong_type ? "has the wrong type" : "is out of range", where, describe(value),
                                     parameter.expected_text()));
    }
    parameter.set(options, typed);
}

} // namespace corticle::config
