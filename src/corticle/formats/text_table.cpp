// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/text_table.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::formats
{

namespace
{

/// The line with what stands in quotes taken out.
std::string outside_quotes(std::string_view line)
{
    std::string outside;
    bool is_quoted = false;
    for (const char c : line)
    {
        is_quoted = c == '"' ? !is_quoted : is_quoted;
        outside += is_quoted ? '"' : c;
    }
    return outside;
}

/// What separates the cells of a line; 0 for one cell.
char separator_of(std::string_view line)
{
    const std::string outside = outside_quotes(trimmed(line));
    for (const char c : {';', '\t', ',', ' '})
    {
        if (outside.find(c) != std::string::npos)
        {
            return c;
        }
    }
    return 0;
}

/// Cuts lines at one separator.
class Cutter
{
  public:
    Cutter(char separator, const std::string& name) : separator_(separator), name_(name) {}

    std::vector<std::string> cells(std::string_view line, std::int64_t number) const
    {
        std::vector<std::string> result;
        for (bool more = true; more;)
        {
            result.push_back(take_cell(line, number));
            more = !line.empty();
            if (more && separator_ != ' ')
            {
                line.remove_prefix(1);
                if (std::ranges::all_of(line, [&](char c) { return is_space(c) && !separates(c); }))
                {
                    result.emplace_back(); // an empty cell behind the last separator
                    more = false;
                }
            }
        }
        return result;
    }

  private:
    bool separates(char c) const { return separator_ == ' ' ? is_space(c) : c == separator_; }

    std::string take_cell(std::string_view& line, std::int64_t number) const
    {
        const auto skip_blanks = [&]
        {
            while (!line.empty() && is_space(line.front()) && (separator_ == ' ' || !separates(line.front())))
            {
                line.remove_prefix(1);
            }
        };
        skip_blanks();
        std::string cell;
        if (!line.empty() && line.front() == '"')
        {
            const std::size_t close = line.find('"', 1);
            if (close == std::string_view::npos)
            {
                fail_reading(name_, fmt::format("line {}: a quote that does not close", number), line, "two quotes");
            }
            cell = line.substr(1, close - 1);
            line.remove_prefix(close + 1);
        }
        else
        {
            const auto end = std::ranges::find_if(line, [&](char c) { return separates(c); });
            const std::string_view taken = line.substr(0, static_cast<std::size_t>(end - line.begin()));
            cell = trimmed(taken);
            line.remove_prefix(taken.size());
        }
        skip_blanks();
        if (!line.empty() && separator_ != ' ' && !separates(line.front()))
        {
            fail_reading(name_, fmt::format("line {}: text behind a quoted cell", number), line, "a separator");
        }
        return cell;
    }

    char separator_;
    const std::string& name_;
};

bool is_number(std::string_view text)
{
    double ignored = 0.0;
    return to_number(text, ignored);
}

/// Gives numbers decimal points, and sees to it that one table has one way of writing them.
class DecimalMarks
{
  public:
    explicit DecimalMarks(const std::string& name) : name_(name) {}

    void normalize(std::string& cell, std::int64_t line)
    {
        const std::size_t comma = cell.find(',');
        if (comma == std::string::npos)
        {
            const bool has_point = cell.find('.') != std::string::npos && is_number(cell);
            line_of_point_ = has_point && line_of_point_ == 0 ? line : line_of_point_;
        }
        else
        {
            std::string with_point = cell;
            with_point[comma] = '.';
            if (!is_number(with_point))
            {
                return; // text
            }
            line_of_comma_ = line_of_comma_ == 0 ? line : line_of_comma_;
            cell = std::move(with_point);
        }
        if (line_of_comma_ > 0 && line_of_point_ > 0)
        {
            fail_reading(name_, "both decimal commas and decimal points",
                         fmt::format("a comma in line {}, a point in line {}", line_of_comma_, line_of_point_),
                         "one of them in the whole file");
        }
    }

  private:
    const std::string& name_;
    std::int64_t line_of_comma_ = 0;
    std::int64_t line_of_point_ = 0;
};

} // namespace

TextTable parse_text_table(std::string_view text, const std::string& name)
{
    TextTable table{name, {}, 0};
    DecimalMarks marks(name);
    text = without_byte_order_mark(text);
    std::string_view line;
    for (std::int64_t number = 1; take_line(text, line); ++number)
    {
        if (is_blank(line) || trimmed(line).front() == '#')
        {
            continue;
        }
        if (table.rows.empty())
        {
            table.separator = separator_of(line);
        }
        // A column alone has no separator: whatever would be one makes a second cell.
        const char separator = table.separator != 0 ? table.separator : separator_of(line);
        TextTable::Row row{number, Cutter(separator, name).cells(line, number)};
        const std::size_t expected = table.rows.empty() ? row.cells.size() : table.rows.front().cells.size();
        if (row.cells.size() != expected)
        {
            fail_reading(name, fmt::format("line {}: wrong number of cells", number),
                         fmt::format("{}", row.cells.size()), fmt::format("{}, as in the first line", expected));
        }
        for (std::string& cell : row.cells)
        {
            if (table.allows_decimal_commas())
            {
                marks.normalize(cell, number);
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace corticle::formats
