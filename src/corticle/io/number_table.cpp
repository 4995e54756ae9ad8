// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/number_table.hpp"

#include "corticle/io/format_error.hpp"
#include "corticle/io/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace corticle
{

namespace
{

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_space(text.front()))
    {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_space(text.back()))
    {
        text.remove_suffix(1);
    }
    return text;
}

std::vector<std::string_view> fields_of(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (std::size_t end = line.find(','); end != std::string_view::npos; end = line.find(','))
    {
        fields.push_back(trimmed(line.substr(0, end)));
        line.remove_prefix(end + 1);
    }
    fields.push_back(trimmed(line));
    return fields;
}

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

std::vector<NumberColumn> columns_of(std::string_view header, const std::string& name)
{
    std::vector<NumberColumn> columns;
    std::set<std::string> keys;
    for (const std::string_view title : fields_of(header))
    {
        NumberColumn column = column_of(title);
        double number = 0.0;
        if (column.key.empty() || !keys.insert(column.key).second || to_number(column.key, number))
        {
            fail_reading(name, "line 1: bad header", title, "a different name for each column, as in \"area [mm2]\"");
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

NumberTable parse_number_table(std::string_view text, const std::string& name)
{
    std::string_view line;
    NumberTable table;
    if (!take_line(text, line))
    {
        fail_reading(name, "not a table of numbers", "an empty file", "a header and rows");
    }
    table.columns = columns_of(line, name);
    for (std::size_t number = 2; take_line(text, line); ++number)
    {
        if (is_blank(line))
        {
            continue;
        }
        const std::vector<std::string_view> fields = fields_of(line);
        if (fields.size() != table.columns.size())
        {
            fail_reading(name, fmt::format("line {}: wrong number of fields", number), fmt::format("{}", fields.size()),
                         fmt::format("{}", table.columns.size()));
        }
        for (std::size_t k = 0; k < fields.size(); ++k)
        {
            double value = std::numeric_limits<double>::quiet_NaN();
            if (!fields[k].empty() && !to_number(fields[k], value))
            {
                fail_reading(name, fmt::format("line {}: bad number in column {}", number, table.columns[k].key),
                             fields[k], "a number");
            }
            table.columns[k].values.push_back(value);
        }
    }
    return table;
}

NumberTable read_number_table(const std::filesystem::path& file)
{
    return parse_number_table(read_whole_file(file), file.string());
}

} // namespace corticle
