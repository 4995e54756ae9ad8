// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/label_table.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace corticle::formats
{

namespace
{

constexpr double largest_label = 2147483647.0;

/// Columns of the text that are read, in the order of LabelTable::columns.
struct ColumnPlaces
{
    std::size_t label = 0;
    std::vector<std::size_t> values;
};

ColumnPlaces take_header(const TextTable& text, std::span<const std::string_view> used, LabelTable& table)
{
    const std::vector<std::string>& names = text.rows.front().cells;
    const auto found = std::ranges::find(names, "label");
    if (found == names.end() || names.size() < 2)
    {
        fail_reading(fmt::format("{}:{}", text.name, text.rows.front().line), "no header",
                     fmt::format("{}", fmt::join(names, ",")), "column names, among them label, as in: label,growth");
    }
    ColumnPlaces places{static_cast<std::size_t>(found - names.begin()), {}};
    for (std::size_t k = 0; k < names.size(); ++k)
    {
        const bool is_used = k == places.label || std::ranges::find(used, names[k]) != used.end();
        if (is_used && std::ranges::count(names, names[k]) > 1)
        {
            fail_reading(text.name, "a column given twice", names[k], "each once");
        }
        if (k != places.label)
        {
            (is_used ? table.columns : table.unused).push_back(names[k]);
        }
        if (k != places.label && is_used)
        {
            places.values.push_back(k);
        }
    }
    return places;
}

double number_of(const std::string& cell, const std::string& where)
{
    double value = 0.0;
    if (!to_number(cell, value) || !std::isfinite(value))
    {
        fail_reading(where, "bad value", cell.empty() ? "nothing" : cell, "a finite number");
    }
    return value;
}

void take_row(const TextTable::Row& row, const std::string& where, const ColumnPlaces& places, LabelTable& table)
{
    const std::string& label_cell = row.cells[places.label];
    const double label = number_of(label_cell, where);
    if (label != std::round(label) || std::abs(label) > largest_label)
    {
        fail_reading(where, "bad label", label_cell, "a whole number of 32 bits");
    }
    std::vector<double> values;
    for (const std::size_t k : places.values)
    {
        values.push_back(number_of(row.cells[k], where));
    }
    if (!table.rows.emplace(static_cast<std::int64_t>(label), std::move(values)).second)
    {
        fail_reading(where, "label given twice", label_cell, "each label once");
    }
}

} // namespace

std::int64_t LabelTable::column(std::string_view name) const
{
    const auto found = std::ranges::find(columns, name);
    return found == columns.end() ? -1 : found - columns.begin();
}

LabelTable read_label_table(const std::filesystem::path& file, std::span<const std::string_view> used)
{
    const TextTable text = parse_text_table(read_whole_file(file), file.string());
    LabelTable table;
    if (text.rows.empty())
    {
        fail_reading(text.name, "no rows", "an empty table", "a header and at least one line, as in: label,growth");
    }
    const ColumnPlaces places = take_header(text, used, table);
    for (std::size_t k = 1; k < text.rows.size(); ++k)
    {
        take_row(text.rows[k], fmt::format("{}:{}", text.name, text.rows[k].line), places, table);
    }
    if (table.rows.empty())
    {
        fail_reading(text.name, "no rows", "an empty table", "a header and at least one line, as in: label,growth");
    }
    return table;
}

} // namespace corticle::formats
