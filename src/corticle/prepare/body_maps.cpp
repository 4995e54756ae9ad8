// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_maps.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/label_table.hpp"
#include "corticle/prepare/map_sampler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace corticle::prepare
{

namespace
{

/// A column of the region table and what its numbers may be.
struct RegionColumn
{
    const char* name;
    double least;
    double most;
    bool is_needed;
};

/// The number of the region that each point is in; empty where the table has no such column.
std::vector<double> by_region(const MapOptions& options, const formats::LabelTable& table,
                              std::span<const double> labels, const RegionColumn& wanted)
{
    const std::int64_t column = table.column(wanted.name);
    if (column < 0 && wanted.is_needed)
    {
        throw InputError(fmt::format("map.region_table {}: has no column {}; expected columns label and growth, and "
                                     "perhaps onset and rate",
                                     options.region_table, wanted.name));
    }
    std::vector<double> values;
    values.reserve(column < 0 ? 0 : labels.size());
    for (std::size_t i = 0; column >= 0 && i < labels.size(); ++i)
    {
        const auto found = table.rows.find(static_cast<std::int64_t>(labels[i]));
        if (found == table.rows.end())
        {
            throw InputError(
                fmt::format("map.region_table {}: has no line for label {:.0f}, which {} holds in the body; "
                            "expected one for each",
                            options.region_table, labels[i], options.region_file));
        }
        values.push_back(found->second[static_cast<std::size_t>(column)]);
        if (!(values.back() >= wanted.least && values.back() <= wanted.most))
        {
            throw InputError(fmt::format("map.region_table {}: {} of label {} is {}; expected {} to {}",
                                         options.region_table, wanted.name, found->first, values.back(), wanted.least,
                                         wanted.most));
        }
    }
    return values;
}

/// Columns that are not read, and lines whose label no point has: a misspelt one should not vanish.
void note_what_is_unused(const formats::LabelTable& table, std::span<const double> labels,
                         std::vector<std::string>& notes)
{
    if (!table.unused.empty())
    {
        notes.push_back(fmt::format("map.region_table: columns not used: {}", fmt::join(table.unused, ", ")));
    }
    const std::set<double> there(labels.begin(), labels.end());
    std::vector<std::int64_t> absent;
    for (const auto& row : table.rows)
    {
        if (!there.contains(static_cast<double>(row.first)))
        {
            absent.push_back(row.first);
        }
    }
    if (!absent.empty())
    {
        notes.push_back(fmt::format("map.region_table: labels at no point of the body: {}", fmt::join(absent, ", ")));
    }
}

/// Growth, onset and rate of the region each point is in.
void apply_regions(const MapOptions& options, std::span<const double> labels, BodyMaps& maps)
{
    constexpr std::array<std::string_view, 3> used{"growth", "onset", "rate"};
    const formats::LabelTable table = formats::read_label_table(options.region_table, used);
    note_what_is_unused(table, labels, maps.notes);
    const std::vector<double> factors = by_region(options, table, labels, {"growth", 0.0, 1000.0, true});
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
        maps.growth[i] *= factors[i];
    }
    maps.onset = by_region(options, table, labels, {"onset", -10.0, 1.0, false});
    maps.rate = by_region(options, table, labels, {"rate", 1e-6, 100.0, false});
}

} // namespace

std::vector<std::string> growth_arrays(const MapOptions& options)
{
    std::vector<std::string> arrays;
    std::string_view rest = options.growth_array;
    while (!rest.empty())
    {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string_view entry = rest.substr(0, comma);
        const std::size_t first = entry.find_first_not_of(' ');
        const std::size_t last = entry.find_last_not_of(' ');
        arrays.emplace_back(first == std::string_view::npos ? "" : entry.substr(first, last - first + 1));
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return arrays;
}

BodyMaps read_body_maps(const MapOptions& options, const TriangleMesh& surface, std::span<const Vec3> positions)
{
    MapSampler sampler(surface, positions);
    BodyMaps maps;
    maps.growth.assign(positions.size(), 1.0);
    if (!options.growth_times.empty())
    {
        for (const std::string& array : growth_arrays(options))
        {
            maps.growth_series.push_back(sampler.numbers({"map.growth_file", options.growth_file, array}, {0.0}));
        }
    }
    else if (!options.growth_file.empty())
    {
        const MapFile map{"map.growth_file", options.growth_file, options.growth_array};
        maps.growth = sampler.numbers(map, {0.0});
    }
    if (!options.region_file.empty())
    {
        maps.region = sampler.labels({"map.region_file", options.region_file, options.region_array});
        apply_regions(options, maps.region, maps);
    }
    if (!options.still_file.empty())
    {
        const std::vector<double> still = sampler.labels({"map.still_file", options.still_file, options.still_array});
        for (std::size_t i = 0; i < still.size(); ++i)
        {
            maps.growth[i] = still[i] != 0.0 ? 0.0 : maps.growth[i];
        }
        if (std::ranges::all_of(still, [](double label) { return label == 0.0; }))
        {
            sampler.warnings.emplace_back("map.still_file: no point of the body lies in this mask: all of it grows");
        }
    }
    if (!options.thickness_file.empty())
    {
        const MapFile map{"map.thickness_file", options.thickness_file, options.thickness_array};
        maps.thickness = sampler.numbers(map, {0.0, true});
    }
    std::ranges::move(sampler.notes, std::back_inserter(maps.notes));
    maps.warnings = std::move(sampler.warnings);
    return maps;
}

} // namespace corticle::prepare
