// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/config/parameters/remodelling_parameters.hpp"
#include "corticle/config/starter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace corticle::config
{

namespace
{

std::string kind_column(const Parameter& parameter)
{
    switch (parameter.kind)
    {
    case Kind::boolean:
        return "boolean";
    case Kind::integer:
        return "integer";
    case Kind::real:
        return "number";
    case Kind::list:
        return parameter.length > 0 ? fmt::format("{} numbers", parameter.length) : "list of numbers";
    case Kind::integers:
        return "list of integers";
    default:
        return "string";
    }
}

std::string range_column(const Parameter& parameter, std::string_view separator)
{
    return parameter.kind == Kind::choice ? fmt::format("\"{}\"", fmt::join(parameter.choices, separator))
                                          : parameter.range.text();
}

/// The default as TOML; of a key of the thesis's formulation, and of one that says nothing by default, the one it has
/// where it says something. Empty where there is none.
std::string default_text(const Parameter& parameter)
{
    Options options = default_options();
    if (parameter.section() == "thesis")
    {
        options.formulation = thesis::Formulation::thesis;
    }
    if (std::holds_alternative<Unsupported>(parameter.get(options)))
    {
        Options with_history = options;
        use_remodelling(with_history);
        return toml_text(parameter.get(with_history));
    }
    return toml_text(parameter.get(options));
}

std::string default_column(const Parameter& parameter)
{
    const std::string text = default_text(parameter);
    return text.empty() ? "none" : text;
}

/// Calls `table(heading)` at the first parameter of each table, then `one(parameter)` for each.
template <class Table, class One>
void each_parameter(Table&& table, One&& one)
{
    std::string current;
    for (const Parameter& parameter : parameters())
    {
        if (parameter.table() != current)
        {
            current = parameter.table();
            table(parameter.heading());
        }
        one(parameter);
    }
}

/// The same, of lists of tables their first element alone.
template <class Table, class One>
void each_kind_of_parameter(Table&& table, One&& one)
{
    std::string heading; // of a table that has no parameter yet
    each_parameter([&](const std::string& text) { heading = text; },
                   [&](const Parameter& parameter)
                   {
                       if (parameter.repeats())
                       {
                           return;
                       }
                       if (!heading.empty())
                       {
                           table(std::exchange(heading, ""));
                       }
                       one(parameter);
                   });
}

/// Keys of [geometry] that only another shape uses.
bool is_of_other_shape(const Parameter& parameter, prepare::Shape shape)
{
    const std::string& key = parameter.key;
    return (key == "geometry.radius_mm" && shape != prepare::Shape::sphere) ||
           (key == "geometry.semi_axes_mm" && shape != prepare::Shape::ellipsoid) ||
           (key == "geometry.size_mm" && shape != prepare::Shape::box) ||
           ((key == "geometry.file" || key == "geometry.unit") && shape != prepare::Shape::file);
}

} // namespace

std::string to_toml(const Options& options)
{
    std::string text = "# Corticle case, every key with its value.\n";
    std::string heading; // of a section that has no key yet
    each_parameter([&](const std::string& table) { heading = "\n" + table + "\n"; },
                   [&](const Parameter& parameter)
                   {
                       const std::string value = toml_text(parameter.get(options));
                       if (!value.empty())
                       {
                           text += std::exchange(heading, "");
                           text += fmt::format("{} = {}{}\n", parameter.name(), value,
                                               parameter.unit.empty() ? "" : "  # [" + parameter.unit + "]");
                       }
                   });
    return text + inputs_toml(options);
}

std::string starter_case(prepare::Shape shape)
{
    Options options = default_options();
    options.geometry.shape = shape;
    options.geometry.file = shape == prepare::Shape::file ? "surface.stl" : "";
    std::string text = "# A starter case: every key with its default. Delete what you do not change.\n"
                       "# `corticle check` prints what a case comes to, `corticle run` runs it.\n";
    bool is_of_list = false; // a list of tables is empty in a starter: one of its tables stands there as a comment
    each_kind_of_parameter(
        [&](const std::string& table)
        {
            is_of_list = table.starts_with("[[");
            text += fmt::format("\n{}{}\n", is_of_list ? "# " : "", table);
        },
        [&](const Parameter& parameter)
        {
            const char* const indent = is_of_list ? "#   " : "";
            const std::string value = toml_text(parameter.get(options));
            const std::string range = range_column(parameter, "\", \"");
            text += fmt::format("{}# {}{}{}\n", indent, parameter.sentence,
                                parameter.unit.empty() ? "" : " Unit: " + parameter.unit + ".",
                                range.empty() ? "" : " Range: " + range + ".");
            const std::string elsewhere = default_text(parameter);
            const std::string& example = elsewhere.empty() ? parameter.example : elsewhere;
            const bool is_comment = !is_of_list && (value.empty() || is_of_other_shape(parameter, shape));
            text += fmt::format("{}{}{} = {}\n", indent, is_comment ? "# " : "", parameter.name(),
                                value.empty() ? example : value);
        });
    return text;
}

std::string schema_text()
{
    std::size_t key_width = 0;
    std::size_t default_width = 0;
    for (const Parameter& parameter : parameters())
    {
        key_width = std::max(key_width, parameter.name().size());
        default_width = std::max(default_width, default_column(parameter).size());
    }
    std::string text;
    each_kind_of_parameter(
        [&](const std::string& table) { text += fmt::format("{}{}\n", text.empty() ? "" : "\n", table); },
        [&](const Parameter& parameter)
        {
            text += fmt::format("  {:<{}}  {:<15}  {:<{}}  {:<10}  {}\n", parameter.name(), key_width,
                                kind_column(parameter), default_column(parameter), default_width,
                                parameter.unit.empty() ? "-" : parameter.unit, range_column(parameter, "\" | \""));
            text += fmt::format("  {:<{}}  {}\n", "", key_width, parameter.sentence);
        });
    return text;
}

std::string schema_markdown()
{
    std::string text;
    each_kind_of_parameter(
        [&](const std::string& table)
        {
            text += fmt::format("{}## {}\n\n| key | type | unit | default | range | meaning |\n"
                                "|---|---|---|---|---|---|\n",
                                text.empty() ? "" : "\n", table);
        },
        [&](const Parameter& parameter)
        {
            const std::string range = range_column(parameter, "\", \"");
            text += fmt::format("| `{}` | {} | {} | `{}` | {} | {} |\n", parameter.name(), kind_column(parameter),
                                parameter.unit, default_column(parameter), range.empty() ? "" : "`" + range + "`",
                                parameter.sentence);
        });
    return text;
}

} // namespace corticle::config
