// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_runs.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/config/toml_document.hpp"
#include "corticle/formats/sha256.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace corticle::sweep
{

namespace
{

/// A key of an axis, as its place in keys.
struct AxisKey
{
    std::size_t axis;
    std::size_t key;
};

std::optional<AxisKey> find_axis(const SweepFile& sweep, std::string_view key)
{
    for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis)
    {
        const auto& keys = sweep.axes[axis].keys;
        if (const auto found = std::ranges::find(keys, key); found != keys.end())
        {
            return AxisKey{axis, static_cast<std::size_t>(found - keys.begin())};
        }
    }
    return std::nullopt;
}

SweepRun make_run(const SweepFile& sweep, const std::string& base_text, std::vector<std::size_t> at,
                  config::KnownChecksums& known)
{
    SweepRun run;
    std::vector<std::string> overrides = sweep.settings;
    for (std::size_t axis = 0; axis < at.size(); ++axis)
    {
        const SweepAxis& described = sweep.axes[axis];
        run.name += (axis == 0 ? "" : "_") + described.names[at[axis]];
        for (std::size_t k = 0; k < described.keys.size(); ++k)
        {
            overrides.push_back(described.keys[k] + "=" + config::toml_text(described.values[at[axis]][k]));
        }
    }
    run.at = std::move(at);
    try
    {
        run.options = config::parse_case(base_text, sweep.base.string(), overrides, sweep.base.parent_path());
        config::identify_inputs(run.options, known);
    }
    catch (const InputError& error)
    {
        throw InputError(fmt::format("run {}: {}", run.name, error.what()));
    }
    run.case_text = config::to_toml(run.options);
    return run;
}

/// The next place, the last axis fastest; false after the last.
bool advance(const SweepFile& sweep, std::vector<std::size_t>& at)
{
    for (std::size_t axis = at.size(); axis-- > 0;)
    {
        if (++at[axis] < sweep.axes[axis].size())
        {
            return true;
        }
        at[axis] = 0;
    }
    return false;
}

bool has_value(const SweepFile& sweep, const SweepRun& run, const AxisKey& place, const std::string& text)
{
    return config::toml_text(sweep.axes[place.axis].values[run.at[place.axis]][place.key]) == text;
}

/// A value of `--only` as TOML, in the type that the axis has.
std::string wanted_text(const SweepFile& sweep, const AxisKey& place, const std::string& text)
{
    const config::Value& example = sweep.axes[place.axis].values.front()[place.key];
    const config::Value value = config::parse_toml_value(text).value_or(text);
    const auto* integer = std::get_if<std::int64_t>(&value);
    return std::holds_alternative<double>(example) && integer != nullptr
               ? config::toml_text(static_cast<double>(*integer))
               : config::toml_text(value);
}

/// Whether a run is meant by a number (from 1), a name, or "section.key=value".
class RunChoice
{
  public:
    RunChoice(const SweepFile& sweep, const std::string& text) : sweep_(sweep), name_(text)
    {
        const char* const end = text.data() + text.size();
        is_number_ = std::from_chars(text.data(), end, number_).ptr == end && !text.empty();
        const auto equals = text.find('=');
        place_ = equals == std::string::npos ? std::nullopt : find_axis(sweep, text.substr(0, equals));
        wanted_ = place_ ? wanted_text(sweep, *place_, text.substr(equals + 1)) : "";
    }
    bool fits(const SweepRun& run, std::size_t i) const
    {
        if (is_number_)
        {
            return i + 1 == number_;
        }
        return place_ ? has_value(sweep_, run, *place_, wanted_) : run.name == name_;
    }

  private:
    const SweepFile& sweep_;
    std::string name_;
    std::size_t number_ = 0;
    bool is_number_ = false;
    std::optional<AxisKey> place_;
    std::string wanted_;
};

std::size_t reference_by_name(const SweepFile& sweep, std::span<const SweepRun> runs)
{
    const SweepReference& reference = sweep.reference;
    const auto found = std::ranges::find(runs, reference.name, &SweepRun::name);
    if (found == runs.end())
    {
        throw InputError(
            fmt::format("reference ({}): got \"{}\", expected \"finest\", \"none\" or the name of a run, such "
                        "as \"{}\"",
                        reference.where, config::printable(reference.name), runs.front().name));
    }
    return static_cast<std::size_t>(found - runs.begin());
}

/// The run with the values of the reference, and on the other axes those of `run`.
std::size_t reference_by_values(const SweepFile& sweep, std::span<const SweepRun> runs, const SweepRun& run)
{
    const SweepReference& reference = sweep.reference;
    std::vector<bool> is_given(sweep.axes.size(), false);
    for (const auto& [key, value] : reference.values)
    {
        is_given[find_axis(sweep, key)->axis] = true;
    }
    const auto fits = [&](const SweepRun& other)
    {
        for (std::size_t axis = 0; axis < is_given.size(); ++axis)
        {
            if (!is_given[axis] && other.at[axis] != run.at[axis])
            {
                return false;
            }
        }
        return std::ranges::all_of(
            reference.values, [&](const auto& entry)
            { return has_value(sweep, other, *find_axis(sweep, entry.first), config::toml_text(entry.second)); });
    };
    const auto found = std::ranges::find_if(runs, fits);
    if (found == runs.end())
    {
        throw InputError(
            fmt::format("reference ({}): no run has these values; expected values of the axes", reference.where));
    }
    return static_cast<std::size_t>(found - runs.begin());
}

} // namespace

void change_settings(SweepFile& sweep, std::span<const std::string> overrides)
{
    const auto key_of = [](const std::string& text) { return text.substr(0, text.find('=')); };
    for (const std::string& text : overrides)
    {
        if (find_axis(sweep, key_of(text)))
        {
            throw InputError(fmt::format("--set {}: {} is on an axis of the sweep; expected another key, or --only",
                                         config::printable(text), key_of(text)));
        }
        std::erase_if(sweep.settings, [&](const std::string& earlier) { return key_of(earlier) == key_of(text); });
        sweep.settings.push_back(text);
    }
}

std::vector<SweepRun> sweep_runs(const SweepFile& sweep)
{
    const std::string base_text = config::read_case_text(sweep.base);
    std::vector<SweepRun> runs;
    config::KnownChecksums known;
    std::vector<std::size_t> at(sweep.axes.size(), 0);
    do
    {
        runs.push_back(make_run(sweep, base_text, at, known));
    } while (advance(sweep, at));
    return runs;
}

std::string case_identity(config::Options options)
{
    const config::OutputOptions defaults;
    options.output.pictures = defaults.pictures;
    options.output.picture_times = defaults.picture_times;
    options.output.checkpoint_minutes = defaults.checkpoint_minutes;
    config::forget_names(options);
    return config::to_toml(options);
}

std::string run_key(const config::Options& options)
{
    constexpr std::size_t digits = 16;
    return formats::sha256_of_text(case_identity(options)).substr(0, digits);
}

std::vector<bool> chosen_runs(const SweepFile& sweep, std::span<const SweepRun> runs, std::span<const std::string> only)
{
    std::vector<bool> chosen(runs.size(), only.empty());
    for (const std::string& text : only)
    {
        const RunChoice choice(sweep, text);
        bool any = false;
        for (std::size_t i = 0; i < runs.size(); ++i)
        {
            const bool is_meant = choice.fits(runs[i], i);
            chosen[i] = chosen[i] || is_meant;
            any = any || is_meant;
        }
        if (!any)
        {
            throw InputError(
                fmt::format("--only {}: no such run; expected a number from 1 to {}, a name such as {}, or "
                            "KEY=VALUE of an axis",
                            config::printable(text), runs.size(), runs.front().name));
        }
    }
    return chosen;
}

std::vector<std::optional<std::size_t>> given_references(const SweepFile& sweep, std::span<const SweepRun> runs)
{
    using Kind = SweepReference::Kind;
    const SweepReference& reference = sweep.reference;
    std::vector<std::optional<std::size_t>> references(runs.size());
    if (reference.kind == Kind::number &&
        (reference.number < 1 || reference.number > static_cast<std::int64_t>(runs.size())))
    {
        throw InputError(fmt::format("reference ({}): got {}, expected a number from 1 to {}", reference.where,
                                     reference.number, runs.size()));
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        if (reference.kind == Kind::number)
        {
            references[i] = static_cast<std::size_t>(reference.number - 1);
        }
        else if (reference.kind == Kind::name)
        {
            references[i] = reference_by_name(sweep, runs);
        }
        else if (reference.kind == Kind::values)
        {
            references[i] = reference_by_values(sweep, runs, runs[i]);
        }
    }
    return references;
}

} // namespace corticle::sweep
