// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/quantity.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/choices.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/record/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::fit
{

namespace
{

using Place = Quantity::Place;

constexpr std::string_view pattern_prefix = "pattern_";
constexpr std::array<std::string_view, 5> pattern_measures{"pattern_depth", "pattern_curvature", "pattern_dice",
                                                           "pattern_pits_5mm", "pattern_pits_10mm"};
constexpr double perfect_pattern = 1.0;

bool is_column(std::string_view key)
{
    const auto columns = metrics::measure_columns();
    return std::ranges::find(columns, key, &metrics::MeasureColumn::key) != columns.end();
}

void require_known_measure(const Quantity& quantity, const std::string& where)
{
    const std::vector<std::string> summary = record::summary_number_keys();
    const bool is_known = quantity.place == Place::end ? std::ranges::find(summary, quantity.measure) != summary.end()
                                                       : is_column(quantity.measure);
    if (!is_known)
    {
        throw InputError(fmt::format("measure ({}): got \"{}\", expected a {}", where,
                                     config::printable(quantity.measure),
                                     quantity.place == Place::end ? "key of summary.json that is a number, such as "
                                                                    "onset_t, or t or week with it"
                                                                  : "column of measures.csv, such as gi_hull"));
    }
}

/// The run must come to where the quantity is taken.
void require_reached(const Quantity& quantity, const std::string& where, const config::Options& base)
{
    if (quantity.place == Place::end)
    {
        return;
    }
    const material::GestationalClock clock = base.time.clock;
    if (quantity.place == Place::week && clock == material::GestationalClock::none)
    {
        throw InputError(fmt::format("week ({}): the base has no clock (time.clock); expected t", where));
    }
    const double t = quantity.place == Place::week ? material::growth_time(clock, quantity.at) : quantity.at;
    if (!(t >= base.time.start - model::same_output_time && t <= base.time.end + model::same_output_time))
    {
        throw InputError(fmt::format("{} ({}): t = {:g}, but the base runs from t = {:g} to {:g}; expected a time "
                                     "within",
                                     quantity.name(), where, t, base.time.start, base.time.end));
    }
}

/// t and week of a table: one number, a list, or none.
std::vector<std::pair<Place, double>> read_places(const TableReader& table, const sweep::SweepPlace& place)
{
    const config::TomlNode* t = table.find("t");
    const config::TomlNode* week = table.find("week");
    if (t != nullptr && week != nullptr)
    {
        throw InputError(fmt::format("t and week ({}): both are given; expected one of them", table.where()));
    }
    if (t == nullptr && week == nullptr)
    {
        return {{Place::end, 0.0}};
    }
    const config::TomlNode& node = t != nullptr ? *t : *week;
    std::vector<std::pair<Place, double>> places;
    const std::vector<config::TomlNode> single{node};
    for (const config::TomlNode& child : node.kind == config::TomlNode::Kind::list ? node.children : single)
    {
        places.emplace_back(t != nullptr ? Place::t : Place::week, sweep::sweep_number(child, place, node.key));
    }
    if (places.empty())
    {
        throw InputError(fmt::format("{} ({}): got an empty list, expected a number", node.key, place.at(node)));
    }
    return places;
}

double read_sd(const TableReader& table, double value)
{
    const std::optional<double> sd = table.positive_if("sd");
    const std::optional<double> relative = table.positive_if("relative_sd");
    const double found = sd ? *sd : relative ? *relative * std::abs(value) : 0.0;
    if (sd.has_value() == relative.has_value() || !(found > 0.0))
    {
        throw InputError(fmt::format("a target ({}): got {}; expected sd > 0, or relative_sd of a value that is not 0",
                                     table.where(), sd && relative ? "sd and relative_sd" : "no standard deviation"));
    }
    return found;
}

Quantity read_measure_target(const TableReader& table, const sweep::SweepPlace& place, const config::Options& base)
{
    const auto places = read_places(table, place);
    Quantity target;
    target.measure = table.text("measure");
    target.place = places.front().first;
    target.at = places.front().second;
    target.value = table.number("value");
    target.sd = read_sd(table, *target.value);
    if (places.size() > 1)
    {
        throw InputError(fmt::format("a target ({}): got {} times, expected one", table.where(), places.size()));
    }
    require_known_measure(target, table.where());
    require_reached(target, table.where(), base);
    return target;
}

study::RealSurfaceOptions read_reading(const TableReader& table)
{
    study::RealSurfaceOptions options;
    const std::string unit = table.text("unit", "mm");
    const std::vector<std::string> units = config::names<formats::UnitOfLength>();
    const auto found = std::ranges::find(units, unit);
    if (found == units.end())
    {
        throw InputError(
            fmt::format("unit ({}): got \"{}\", expected mm, cm or m", table.where(), config::printable(unit)));
    }
    options.unit = static_cast<formats::UnitOfLength>(found - units.begin());
    if (const config::TomlNode* labels = table.find("labels"))
    {
        for (const config::TomlNode& child : labels->children)
        {
            const auto* label = std::get_if<std::int64_t>(&child.value);
            if (label == nullptr)
            {
                throw InputError(fmt::format("labels ({}): got {}, expected whole numbers", table.where(),
                                             config::describe(child.value)));
            }
            options.mask.labels.push_back(static_cast<int>(*label));
        }
    }
    return options;
}

/// One quantity for each measure of a real surface.
std::vector<Quantity> read_surface_target(const TableReader& table, const sweep::SweepPlace& place,
                                          const config::Options& base)
{
    Quantity common;
    common.file = std::filesystem::absolute(place.directory / table.text("file")).lexically_normal();
    common.reading = read_reading(table);
    const auto places = read_places(table, place);
    common.place = places.front().first;
    common.at = places.front().second;
    if (places.size() > 1 || common.place == Place::end || table.find("value") != nullptr)
    {
        throw InputError(fmt::format("a target with a file ({}): expected one t or week, and no value", table.where()));
    }
    require_reached(common, table.where(), base);
    const auto rows = study::surface_rows(study::read_real_surface(common.file, common.reading));
    std::vector<Quantity> targets;
    for (const config::TomlNode& child : table.at("measures").children)
    {
        Quantity target = common;
        target.measure = sweep::sweep_text(child, place, "measures");
        const auto row = std::ranges::find(rows, target.measure, &metrics::SurfaceRow::key);
        const bool is_pattern = std::ranges::find(pattern_measures, target.measure) != pattern_measures.end();
        if (row == rows.end() && !is_pattern)
        {
            throw InputError(fmt::format("measures ({}): got \"{}\", expected keys that `corticle measure` prints, or "
                                         "pattern_depth, pattern_curvature, pattern_dice, pattern_pits_5mm, "
                                         "pattern_pits_10mm",
                                         place.at(child), config::printable(target.measure)));
        }
        target.value = is_pattern ? perfect_pattern : row->value;
        target.sd = read_sd(table, *target.value);
        targets.push_back(target);
    }
    if (targets.empty())
    {
        throw InputError(fmt::format("measures ({}): got none, expected a list of measures", table.where()));
    }
    return targets;
}

void require_distinct(const std::vector<Quantity>& quantities, const config::TomlNode& list,
                      const sweep::SweepPlace& place)
{
    for (const Quantity& one : quantities)
    {
        if (std::ranges::count(quantities, one.name(), &Quantity::name) > 1)
        {
            throw InputError(fmt::format("{} ({}): {} twice; expected it once", list.key, place.at(list), one.name()));
        }
    }
}

} // namespace

std::string Quantity::name() const
{
    const std::string of_file = file.empty() ? "" : file.filename().string() + ":";
    return of_file + measure +
           (place == Place::end ? "" : fmt::format("@{}={:g}", place == Place::t ? "t" : "week", at));
}

std::vector<Quantity> read_targets(const config::TomlNode& list, const sweep::SweepPlace& place,
                                   const config::Options& base)
{
    static constexpr std::array<std::string_view, 10> keys{"measure",     "t",    "week",     "value",  "sd",
                                                           "relative_sd", "file", "measures", "labels", "unit"};
    std::vector<Quantity> targets;
    for (const config::TomlNode& node : tables_of(list, place))
    {
        const TableReader table(node, place, "a target", keys);
        if (table.find("file") != nullptr)
        {
            const std::vector<Quantity> found = read_surface_target(table, place, base);
            targets.insert(targets.end(), found.begin(), found.end());
            continue;
        }
        for (const char* key : {"measures", "labels", "unit"})
        {
            if (table.find(key) != nullptr)
            {
                throw InputError(fmt::format("{} ({}): without file; expected measure, or a file", key, table.where()));
            }
        }
        targets.push_back(read_measure_target(table, place, base));
    }
    require_distinct(targets, list, place);
    return targets;
}

std::vector<Quantity> read_predictions(const config::TomlNode& list, const sweep::SweepPlace& place,
                                       const config::Options& base)
{
    static constexpr std::array<std::string_view, 3> keys{"measure", "t", "week"};
    std::vector<Quantity> quantities;
    for (const config::TomlNode& node : tables_of(list, place))
    {
        const TableReader table(node, place, "a prediction", keys);
        for (const auto& [kind, at] : read_places(table, place))
        {
            Quantity quantity;
            quantity.measure = table.text("measure");
            quantity.place = kind;
            quantity.at = at;
            require_known_measure(quantity, table.where());
            require_reached(quantity, table.where(), base);
            quantities.push_back(quantity);
        }
    }
    require_distinct(quantities, list, place);
    return quantities;
}

Quantity parse_quantity(const std::string& text, const std::string& where, const config::Options& base)
{
    Quantity quantity;
    const std::size_t at = text.find('@');
    quantity.measure = text.substr(0, at);
    if (at != std::string::npos)
    {
        quantity.place = Place::t;
        if (!formats::to_number(std::string_view(text).substr(at + 1), quantity.at))
        {
            throw InputError(
                fmt::format("measures ({}): got \"{}\", expected KEY or KEY@T", where, config::printable(text)));
        }
    }
    require_known_measure(quantity, where);
    require_reached(quantity, where, base);
    return quantity;
}

} // namespace corticle::fit
