// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/label_table.hpp"

#include "corticle/io/format_error.hpp"
#include "corticle/io/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace corticle
{

namespace
{

constexpr double largest_label = 2147483647.0;

std::vector<std::string_view> split(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();)
    {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        std::string_view field = line.substr(begin, end - begin);
        const auto first = field.find_first_not_of(" \t\"\r");
        const auto last = field.find_last_not_of(" \t\"\r");
        fields.push_back(first == std::string_view::npos ? std::string_view{} : field.substr(first, last - first + 1));
        begin = end + 1;
    }
    return fields;
}

/// A table while its lines come in.
class TableReader
{
  public:
    explicit TableReader(std::string name) : name_(std::move(name)) {}

    void take(std::string_view line, std::int64_t number)
    {
        where_ = fmt::format("{}:{}", name_, number);
        if (is_blank(line) || line[line.find_first_not_of(" \t")] == '#')
        {
            return;
        }
        label_column_ ? take_row(split(line)) : take_header(split(line), line);
    }

    LabelTable finish()
    {
        if (table_.rows.empty())
        {
            fail_reading(name_, "no rows", "an empty table", "a header and at least one line, as in: label,growth");
        }
        return std::move(table_);
    }

  private:
    void take_header(const std::vector<std::string_view>& fields, std::string_view line)
    {
        const auto found = std::find(fields.begin(), fields.end(), "label");
        if (found == fields.end() || fields.size() < 2)
        {
            fail_reading(where_, "no header", line, "column names, among them label, as in: label,growth");
        }
        label_column_ = static_cast<std::size_t>(found - fields.begin());
        for (auto field = fields.begin(); field != fields.end(); ++field)
        {
            if (field != found)
            {
                table_.columns.emplace_back(*field);
            }
        }
    }

    double number(std::string_view field) const
    {
        double value = 0.0;
        if (!to_number(field, value) || !std::isfinite(value))
        {
            fail_reading(where_, "bad value", field, "a finite number");
        }
        return value;
    }

    void take_row(const std::vector<std::string_view>& fields)
    {
        if (fields.size() != table_.columns.size() + 1)
        {
            fail_reading(where_, "wrong number of fields", fmt::format("{}", fields.size()),
                         fmt::format("{}", table_.columns.size() + 1));
        }
        std::vector<double> values;
        values.reserve(fields.size());
        for (const std::string_view field : fields)
        {
            values.push_back(number(field));
        }
        const double label = values[*label_column_];
        values.erase(values.begin() + static_cast<std::ptrdiff_t>(*label_column_));
        if (label != std::round(label) || std::abs(label) > largest_label)
        {
            fail_reading(where_, "bad label", fields[*label_column_], "a whole number of 32 bits");
        }
        if (!table_.rows.emplace(static_cast<std::int64_t>(label), std::move(values)).second)
        {
            fail_reading(where_, "label given twice", fields[*label_column_], "each label once");
        }
    }

    std::string name_;
    std::string where_;
    std::optional<std::size_t> label_column_;
    LabelTable table_;
};

} // namespace

std::int64_t LabelTable::column(const std::string& name) const
{
    const auto found = std::find(columns.begin(), columns.end(), name);
    return found == columns.end() ? -1 : found - columns.begin();
}

LabelTable read_label_table(const std::filesystem::path& file)
{
    const std::string text = read_whole_file(file);
    TableReader reader(file.string());
    std::string_view rest = text;
    std::string_view line;
    for (std::int64_t number = 1; take_line(rest, line); ++number)
    {
        reader.take(line, number);
    }
    return reader.finish();
}

} // namespace corticle
