// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_table.hpp"

#include "corticle/base/error.hpp"
#include "corticle/record/summary.hpp"
#include "corticle/study/comparison/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace corticle::sweep
{

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A measure at growth time t; NaN where the run did not come so far, or cannot be read.
double measure_at(const std::filesystem::path& folder, const std::string& key, double t)
{
    try
    {
        const record::RunContents run = record::read_run(folder);
        const auto& columns = run.measures.columns;
        const auto column = std::ranges::find(columns, key, study::measure_key);
        return column == columns.end() ? none : metrics::interpolate(run.measures.find("t")->values, column->values, t);
    }
    catch (const InputError&)
    {
        return none;
    }
}

/// The finest run: one that completed before one that did not, then most particles, then most steps.
std::optional<std::size_t> finest_run(const SweepTable& table)
{
    const auto rank = [](const SweepRow& row)
    { return std::tuple(row.state.status == "completed", row.number("particles"), row.number("steps")); };
    std::optional<std::size_t> best;
    for (const SweepRow& row : table.rows)
    {
        const bool has_steps = row.number("steps") > 0.0;
        best = has_steps && (!best || rank(row) > rank(table.rows[*best])) ? row.run : best;
    }
    return best;
}

JDifference difference(const std::array<std::filesystem::path, 2>& folders, double latest)
{
    try
    {
        const study::JComparison found = study::compare_last_J(folders, latest);
        return {found.J.mean, found.t[1], found.J.interpolation_error};
    }
    catch (const InputError&)
    {
        return {}; // one of them has no such output time
    }
}

} // namespace

double SweepRow::number(const std::string& key) const
{
    const auto found = state.numbers.find(key);
    return found == state.numbers.end() ? none : found->second;
}

double SweepRow::step_s() const
{
    return 1e-6 * number("us_per_particle_step") * number("particles");
}

void require_known_measures(const SweepFile& sweep)
{
    const std::vector<std::string> known = record::summary_number_keys();
    for (const SweepMeasure& measure : sweep.measures)
    {
        if (std::ranges::find(known, measure.key) == known.end())
        {
            throw InputError(
                fmt::format("measures ({}): got \"{}\", expected keys of summary.json that are numbers, such "
                            "as gi_hull, or KEY@T",
                            measure.where, config::printable(measure.text)));
        }
    }
}

void read_measures(const SweepTable& table, SweepRow& row)
{
    row.measures.clear();
    for (const SweepMeasure& measure : table.sweep.measures)
    {
        row.measures.push_back(measure.t ? measure_at(table.out / row.folder, measure.key, *measure.t)
                                         : row.number(measure.key));
    }
}

void compare_to_references(SweepTable& table)
{
    if (table.sweep.reference.kind == SweepReference::Kind::none)
    {
        return;
    }
    const std::vector<std::optional<std::size_t>> given = given_references(table.sweep, table.runs);
    const std::optional<std::size_t> finest =
        table.sweep.reference.kind == SweepReference::Kind::finest ? finest_run(table) : std::nullopt;
    std::vector<double> latest = table.sweep.compare_t;
    if (latest.empty())
    {
        latest.push_back(std::numeric_limits<double>::infinity());
    }
    for (SweepRow& row : table.rows)
    {
        const std::optional<std::size_t> number = finest ? finest : given[row.run];
        if (!number)
        {
            continue;
        }
        const SweepRow& reference = table.rows[*number];
        row.reference = table.runs[reference.run].name;
        row.J.clear();
        for (const double t : latest)
        {
            row.J.push_back(difference({table.out / reference.folder, table.out / row.folder}, t));
        }
    }
}

} // namespace corticle::sweep
