// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/value.hpp"
#include "corticle/study/sweep/sweep_engine.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corticle::sweep
{

/// One direction of a sweep: keys of the case that change together.
struct SweepAxis
{
    std::vector<std::string> keys;                  ///< at least one; those of zipped axes together
    std::vector<std::vector<config::Value>> values; ///< of each place on the axis one value for each key
    std::vector<std::string> names;                 ///< of the places, in names of runs and captions: "cfl-0.4"
    std::vector<std::string> labels;                ///< the same without the keys: "0.4"
    bool has_given_names = false;                   ///< the names were chosen by the user
    bool is_log = false;                            ///< its plots have a logarithmic axis

    std::size_t size() const { return values.size(); }
};

/// The run to which J of a run is compared.
struct SweepReference
{
    enum class Kind
    {
        none,
        finest, ///< of the runs that completed the one of most particles, then of most steps
        number, ///< counted from 1
        name,
        values ///< the run that has these and agrees with the run at hand on the other axes
    };
    Kind kind = Kind::finest;
    std::int64_t number = 0;
    std::string name;
    std::vector<std::pair<std::string, config::Value>> values;
    std::string where; ///< "sweep.toml:4"
};

/// A straight line drawn into the plot of a measure against an axis: what theory says.
struct SweepLine
{
    std::string axis;    ///< a key
    std::string measure; ///< as in measures
    std::string label;
    double slope = 0.0;
    double intercept = 0.0;
};

/// A measure of a run: a key of summary.json, or "KEY@T", its value at growth time T.
struct SweepMeasure
{
    std::string text; ///< as given
    std::string key;
    std::optional<double> t;
    std::string where;
};

/// What a sweep file says.
struct SweepFile
{
    std::filesystem::path base; ///< the case that the runs start from, absolute
    std::string title;
    std::vector<std::string> settings; ///< "section.key=value" for all runs
    std::vector<SweepAxis> axes;       ///< at least one
    SweepReference reference;
    std::vector<SweepMeasure> measures; ///< columns of the table
    std::vector<std::string> plots;     ///< of these, those that are drawn against the axes
    std::vector<double> compare_t; ///< J is compared at the last common output time not after each; empty: the last
    std::vector<SweepLine> lines;
    bool has_pictures = true;
    EngineOptions engine; ///< of array jobs
};

inline constexpr std::size_t most_sweep_runs = 10000;

/// Reads a sweep (TOML): base, title, [set], [[axis]], reference, measures, plots, pictures,
/// compare_t, [[line]], [engine]. Every key of
/// the case, type and range is checked, but not yet whether the values of a run go together.
/// @throws InputError, one line: what, where (file and line), got, expected
SweepFile read_sweep(const std::filesystem::path& file);

/// The same from text; `name` is used in messages, `directory` resolves relative paths.
SweepFile parse_sweep(std::string_view text, const std::string& name, const std::filesystem::path& directory);

} // namespace corticle::sweep
