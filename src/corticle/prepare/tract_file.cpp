// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/tract_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/text_table.hpp"
#include "corticle/mechanics/tracts/tract_term.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace corticle::prepare
{

namespace
{

constexpr std::array<std::string_view, 2> label_columns{"from", "to"};
constexpr std::array<std::string_view, 6> place_columns{"from_x", "from_y", "from_z", "to_x", "to_y", "to_z"};
constexpr std::array<std::string_view, 3> own_columns{"stiffness", "rest", "growth_rate"};
constexpr double spacings_about_a_place = 2.0;

std::optional<std::size_t> column_of(const formats::TextTable& table, std::string_view name)
{
    const std::vector<std::string>& header = table.rows.front().cells;
    const auto found = std::ranges::find(header, name);
    return found == header.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - header.begin()));
}

bool has_columns(const formats::TextTable& table, std::span<const std::string_view> names)
{
    return std::ranges::all_of(names, [&](std::string_view name) { return column_of(table, name).has_value(); });
}

/// A table of tracts being read, row by row.
class TractTable
{
  public:
    TractTable(const tracts::TractOptions& options, const model::Model& model)
        : options_(options), model_(model),
          table_(formats::parse_text_table(formats::read_whole_file(options.file), options.file))
    {
        if (table_.rows.size() < 2)
        {
            formats::fail_reading(table_.name, "no rows", "an empty table", "a header, from,to, and at least one line");
        }
        by_label_ = has_columns(table_, label_columns);
        if (!by_label_ && !has_columns(table_, place_columns))
        {
            formats::fail_reading(table_.name, "no ends", fmt::format("{}", fmt::join(table_.rows[0].cells, ",")),
                                  fmt::format("columns from and to, or {}", fmt::join(place_columns, ", ")));
        }
        for (const std::string& name : table_.rows[0].cells)
        {
            const bool is_end = by_label_ ? std::ranges::find(label_columns, name) != label_columns.end()
                                          : std::ranges::find(place_columns, name) != place_columns.end();
            if ((!is_end && std::ranges::find(own_columns, name) == own_columns.end()) ||
                std::ranges::count(table_.rows[0].cells, name) > 1)
            {
                formats::fail_reading(table_.name, "a column of no use", name,
                                      fmt::format("each once: from and to, or {}; and {}",
                                                  fmt::join(place_columns, ", "), fmt::join(own_columns, ", ")));
            }
        }
    }

    tracts::Tracts read()
    {
        tracts::Tracts result;
        result.push = options_.pushes;
        result.ramp_time = options_.ramp_time;
        for (std::size_t row = 1; row < table_.rows.size(); ++row)
        {
            const std::int32_t from = end_of(row, 0, result.ends);
            const std::int32_t to = end_of(row, 1, result.ends);
            const auto place = [&](std::int32_t end)
            { return tracts::centroid(result.ends[static_cast<std::size_t>(end)], model_.cloud.positions); };
            if (norm(place(from) - place(to)) < 1e-6 * model_.cloud.spacing)
            {
                formats::fail_reading(where(row), "a tract of no length", "two ends in one place", "two places");
            }
            result.tracts.push_back({from, to, own(row, "stiffness", options_.stiffness, 1e-9, 1e9),
                                     own(row, "rest", options_.rest, 0.0, 10.0),
                                     own(row, "growth_rate", options_.rate, 0.0, 1000.0)});
        }
        return result;
    }

  private:
    std::string where(std::size_t row) const { return fmt::format("{}:{}", table_.name, table_.rows[row].line); }

    double number(std::size_t row, std::string_view name, double low, double high) const
    {
        const std::string& cell = table_.rows[row].cells[*column_of(table_, name)];
        double value = 0.0;
        if (!formats::to_number(std::string_view(cell), value) || !(value >= low && value <= high))
        {
            formats::fail_reading(where(row), fmt::format("bad {}", name), cell.empty() ? "nothing" : cell,
                                  fmt::format("a number from {:g} to {:g}", low, high));
        }
        return value;
    }
    double own(std::size_t row, std::string_view name, double usual, double low, double high) const
    {
        return column_of(table_, name) ? number(row, name, low, high) : usual;
    }

    /// The end of a row on this side, made once for each label and place.
    std::int32_t end_of(std::size_t row, std::size_t side, std::vector<tracts::TractEnd>& ends)
    {
        std::array<double, 3> key{};
        if (by_label_)
        {
            key[0] = number(row, label_columns[side], -2147483648.0, 2147483647.0);
        }
        for (std::size_t axis = 0; !by_label_ && axis < 3; ++axis)
        {
            key[axis] = number(row, place_columns[3 * side + axis], -1e6, 1e6);
        }
        const auto known = known_.find(key);
        if (known != known_.end())
        {
            return known->second;
        }
        ends.push_back(by_label_ ? of_label(row, key[0]) : about(row, {key[0], key[1], key[2]}));
        return known_[key] = static_cast<std::int32_t>(ends.size() - 1);
    }

    tracts::TractEnd of_label(std::size_t row, double label) const
    {
        const std::vector<double>& region = model_.tissue.region;
        if (region.empty())
        {
            throw InputError(
                fmt::format("tracts.file {}: names labels, but the body has none; expected map.region_file "
                            "and map.region_table, or the places of the ends",
                            options_.file));
        }
        return end_where(row, fmt::format("label {:g}", label), [&](std::size_t i) { return region[i] == label; });
    }

    tracts::TractEnd about(std::size_t row, const Vec3& place) const
    {
        const double radius =
            options_.radius_mm > 0.0 ? options_.radius_mm : spacings_about_a_place * model_.cloud.spacing;
        return end_where(row, fmt::format("({:g}, {:g}, {:g}) mm", place.x, place.y, place.z),
                         [&](std::size_t i)
                         { return squared_norm(model_.cloud.positions[i] - place) <= radius * radius; });
    }

    template <class Holds>
    tracts::TractEnd end_where(std::size_t row, const std::string& what, Holds&& holds) const
    {
        tracts::TractEnd end;
        double mass = 0.0;
        for (std::size_t i = 0; i < model_.cloud.positions.size(); ++i)
        {
            if (holds(i))
            {
                end.nodes.push_back(static_cast<std::int32_t>(i));
                end.shares.push_back(model_.cloud.volumes[i]);
                mass += model_.cloud.volumes[i];
            }
        }
        if (end.nodes.empty())
        {
            formats::fail_reading(where(row), "an end that holds nothing", what, "one where the body is");
        }
        std::ranges::for_each(end.shares, [mass](double& share) { share /= mass; });
        return end;
    }

    const tracts::TractOptions& options_;
    const model::Model& model_;
    formats::TextTable table_;
    bool by_label_ = false;
    std::map<std::array<double, 3>, std::int32_t> known_;
};

} // namespace

tracts::Tracts read_tracts(const tracts::TractOptions& options, const model::Model& model)
{
    return options.file.empty() ? tracts::Tracts{} : TractTable(options, model).read();
}

} // namespace corticle::prepare
