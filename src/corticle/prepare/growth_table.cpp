// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/growth_table.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::prepare
{

namespace
{

constexpr std::array columns{"week", "tissue", "tangential", "radial"};
using Places = std::array<std::size_t, columns.size()>;

Places find_columns(const formats::TextTable& table)
{
    Places places{};
    const std::vector<std::string>& header = table.rows.front().cells;
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
        const auto found = std::ranges::find(header, std::string_view(columns[k]));
        if (found == header.end())
        {
            formats::fail_reading(table.name, "no column", columns[k], "the columns week, tissue, tangential, radial");
        }
        places[k] = static_cast<std::size_t>(found - header.begin());
    }
    return places;
}

double number_in(const std::string& cell, const std::string& where, double low, double high)
{
    double value = 0.0;
    if (!formats::to_number(std::string_view(cell), value) || !(value >= low && value <= high))
    {
        formats::fail_reading(where, "bad number", cell.empty() ? "nothing" : cell,
                              fmt::format("{:g} to {:g}", low, high));
    }
    return value;
}

material::TissueKind tissue_in(const std::string& cell, const std::string& where)
{
    const auto found = std::ranges::find(material::tissue_names, std::string_view(cell));
    if (found == material::tissue_names.end())
    {
        formats::fail_reading(where, "bad tissue", cell, "cortex, white, deep, ventricle or still");
    }
    return static_cast<material::TissueKind>(found - material::tissue_names.begin());
}

} // namespace

std::vector<material::GrowthRow> read_growth_table(const std::filesystem::path& file)
{
    const formats::TextTable table = formats::parse_text_table(formats::read_whole_file(file), file.string());
    if (table.rows.size() < 2)
    {
        formats::fail_reading(table.name, "no rows", "an empty table",
                              "a header, week,tissue,tangential,radial, and "
                              "at least one line");
    }
    const Places places = find_columns(table);
    std::vector<material::GrowthRow> rows;
    for (std::size_t k = 1; k < table.rows.size(); ++k)
    {
        const std::string where = fmt::format("{}:{}", table.name, table.rows[k].line);
        const auto cell = [&](std::size_t column) -> const std::string& { return table.rows[k].cells[places[column]]; };
        rows.push_back({number_in(cell(0), where, 0.0, 100.0), tissue_in(cell(1), where),
                        number_in(cell(2), where, 1e-3, 1e3), number_in(cell(3), where, 1e-3, 1e3)});
    }
    return rows;
}

std::vector<material::GrowthRow> growth_rows(const PreparationOptions& options)
{
    return options.tissue.growth_source == material::GrowthSource::table
               ? read_growth_table(options.growth_table)
               : material::fetal_growth(options.time.start_week.value());
}

} // namespace corticle::prepare
