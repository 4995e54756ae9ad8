// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/number_table.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace corticle::formats
{

namespace
{

NumberColumn column_of(std::string_view title)
{
    const std::size_t bracket = title.find('[');
    if (bracket == std::string_view::npos || title.back() != ']')
    {
        return {std::string(title), {}, {}};
    }
    return {std::string(trimmed(title.substr(0, bracket))),
            std::string(trimmed(title.substr(bracket + 1, title.size() - bracket - 2))),
            {}};
}

std::vector<NumberColumn> columns_of(const TextTable::Row& header, const std::string& name)
{
    std::vector<NumberColumn> columns;
    std::set<std::string> keys;
    for (const std::string& title : header.cells)
    {
        NumberColumn column = column_of(title);
        double number = 0.0;
        if (column.key.empty() || !keys.insert(column.key).second || to_number(column.key, number))
        {
            fail_reading(name, fmt::format("line {}: bad header", header.line), title,
                         "a different name for each column, as in \"area [mm2]\"");
        }
        columns.push_back(std::move(column));
    }
    return columns;
}

} // namespace

const NumberColumn* NumberTable::find(std::string_view key) const
{
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const NumberColumn& column) { return column.key == key; });
    return found == columns.end() ? nullptr : &*found;
}

NumberTable parse_number_table(std::string_view text, const std::string& name, std::span<const std::string_view> used)
{
    const TextTable cells = parse_text_table(text, name);
    NumberTable table;
    if (cells.rows.empty())
    {
        fail_reading(name, "not a table of numbers", "an empty file", "a header and rows");
    }
    table.columns = columns_of(cells.rows.front(), name);
    for (std::size_t row = 1; row < cells.rows.size(); ++row)
    {
        for (std::size_t k = 0; k < table.columns.size(); ++k)
        {
            const std::string& cell = cells.rows[row].cells[k];
            double value = std::numeric_limits<double>::quiet_NaN();
            const bool is_used = used.empty() || std::ranges::find(used, table.columns[k].key) != used.end();
            if (!cell.empty() && !to_number(cell, value) && is_used)
            {
                fail_reading(
                    name, fmt::format("line {}: bad number in column {}", cells.rows[row].line, table.columns[k].key),
                    cell, "a number");
            }
            table.columns[k].values.push_back(value);
        }
    }
    return table;
}

NumberTable read_number_table(const std::filesystem::path& file, std::span<const std::string_view> used)
{
    return parse_number_table(read_whole_file(file), file.string(), used);
}

} // namespace corticle::formats
