// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/version.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/study/markdown.hpp"
#include "corticle/study/sweep/sweep_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace corticle::sweep
{

namespace
{

using Json = nlohmann::ordered_json;

/// A field of a CSV file, quoted where it must be.
std::string csv_field(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos)
    {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text)
    {
        quoted += c == '"' ? "\"\"" : c == '\n' || c == '\r' ? " " : std::string(1, c);
    }
    return quoted + "\"";
}

std::string csv_number(double value)
{
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

/// Text without quotes, numbers as they are.
std::string plain_text(const config::Value& value)
{
    const auto* text = std::get_if<std::string>(&value);
    const auto* real = std::get_if<double>(&value);
    return text != nullptr ? *text : real != nullptr ? fmt::format("{}", *real) : config::toml_text(value);
}

/// How often J of a run is compared.
std::size_t comparison_count(const SweepFile& sweep)
{
    return std::max<std::size_t>(1, sweep.compare_t.size());
}

/// For each axis its keys, or where its places have given names one column of names.
std::vector<std::string> axis_columns(const SweepFile& sweep)
{
    std::vector<std::string> columns;
    for (const SweepAxis& axis : sweep.axes)
    {
        if (axis.has_given_names)
        {
            columns.push_back(fmt::format("{}", fmt::join(axis.keys, " / ")));
            continue;
        }
        for (const std::string& key : axis.keys)
        {
            const std::string unit = config::find_parameter(key)->unit;
            columns.push_back(fmt::format("`{}`{}", key, unit.empty() ? "" : " [" + unit + "]"));
        }
    }
    return columns;
}

std::vector<std::string> axis_cells(const SweepFile& sweep, const SweepRun& run)
{
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
    {
        const SweepAxis& axis = sweep.axes[i];
        if (axis.has_given_names)
        {
            cells.push_back(study::markdown_cell(axis.names[run.at[i]]));
            continue;
        }
        for (const config::Value& value : axis.values[run.at[i]])
        {
            cells.push_back(study::markdown_cell(plain_text(value)));
        }
    }
    return cells;
}

std::string runs_table(const SweepTable& table)
{
    std::vector<std::string> header = axis_columns(table.sweep);
    for (const char* column : {"status", "duration [s]", "step [s]", "steps", "t"})
    {
        header.emplace_back(column);
    }
    for (const SweepMeasure& measure : table.sweep.measures)
    {
        header.push_back(fmt::format("`{}`", measure.text));
    }
    const bool is_compared = table.sweep.reference.kind != SweepReference::Kind::none;
    for (std::size_t k = 0; is_compared && k < comparison_count(table.sweep); ++k)
    {
        header.insert(header.end(), {"MD of J", "at t", "its interpolation error"});
    }
    std::vector<std::vector<std::string>> rows;
    for (const SweepRow& row : table.rows)
    {
        std::vector<std::string> cells = axis_cells(table.sweep, table.runs[row.run]);
        cells.push_back(row.state.status);
        for (const double value : {row.number("wall_s"), row.step_s(), row.number("steps"), row.number("t")})
        {
            cells.push_back(study::table_number(value));
        }
        for (const double value : row.measures)
        {
            cells.push_back(study::table_number(value));
        }
        for (std::size_t k = 0; is_compared && k < comparison_count(table.sweep); ++k)
        {
            const JDifference J = k < row.J.size() ? row.J[k] : JDifference{};
            const bool is_reference = row.reference == table.runs[row.run].name;
            cells.insert(cells.end(), {is_reference ? "reference" : study::table_number(J.mean),
                                       study::table_number(J.t), study::table_number(J.error)});
        }
        rows.push_back(std::move(cells));
    }
    return study::markdown_table(header, rows);
}

std::string failures(const SweepTable& table)
{
    std::string text;
    for (const SweepRow& row : table.rows)
    {
        if (!row.state.reason.empty())
        {
            text += fmt::format("- {}: {}\n", study::markdown_cell(table.runs[row.run].name),
                                study::markdown_cell(row.state.reason));
        }
    }
    return text.empty() ? "" : "## Runs that did not complete\n\n" + text + "\n";
}

std::string warnings(const SweepTable& table)
{
    std::string text;
    for (const SweepRow& row : table.rows)
    {
        for (const std::string& warning : row.state.warnings)
        {
            text += fmt::format("- {}: {}\n", study::markdown_cell(table.runs[row.run].name),
                                study::markdown_cell(warning));
        }
    }
    return text.empty() ? "" : "## Warnings of the runs\n\n" + text + "\n";
}

std::string reference_text(const SweepTable& table)
{
    const auto named = std::ranges::find_if(table.rows, [](const SweepRow& row) { return !row.reference.empty(); });
    if (named == table.rows.end())
    {
        return "";
    }
    const bool is_one = std::ranges::all_of(table.rows, [&](const SweepRow& row)
                                            { return row.reference.empty() || row.reference == named->reference; });
    return fmt::format(
        "MD of J is the mean of |J - J'| over the points (thesis eq. 27), J' that of {}, at the last output "
        "time{} that both have. Where the points differ J is interpolated; differences below the "
        "interpolation error say nothing.\n\n",
        is_one ? "run " + study::markdown_cell(named->reference) : "the run with the values of the reference",
        table.sweep.compare_t.empty() ? ""
                                      : fmt::format(" up to t = {}", fmt::join(table.sweep.compare_t, " and up to ")));
}

Json number_json(double value)
{
    return std::isnan(value) ? Json(nullptr) : Json(value);
}

Json value_json(const config::Value& value)
{
    return std::visit(
        [](const auto& held) -> Json
        {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(held)>, config::Unsupported>)
            {
                return nullptr;
            }
            else
            {
                return held;
            }
        },
        value);
}

Json row_json(const SweepTable& table, const SweepRow& row)
{
    const SweepRun& run = table.runs[row.run];
    Json json;
    json["number"] = row.run + 1;
    json["name"] = run.name;
    json["folder"] = row.folder.string();
    json["values"] = Json::object();
    for (std::size_t i = 0; i < table.sweep.axes.size(); ++i)
    {
        const SweepAxis& axis = table.sweep.axes[i];
        for (std::size_t k = 0; k < axis.keys.size(); ++k)
        {
            json["values"][axis.keys[k]] = value_json(axis.values[run.at[i]][k]);
        }
    }
    json["status"] = row.state.status;
    json["reason"] = row.state.reason.empty() ? Json(nullptr) : Json(row.state.reason);
    json["warnings"] = row.state.warnings;
    json["kept"] = row.is_kept;
    json["step_s"] = number_json(row.step_s());
    json["measures"] = Json::object();
    for (std::size_t i = 0; i < row.measures.size(); ++i)
    {
        json["measures"][table.sweep.measures[i].text] = number_json(row.measures[i]);
    }
    json["reference"] = row.reference.empty() ? Json(nullptr) : Json(row.reference);
    json["md_J"] = Json::array();
    for (const JDifference& J : row.J)
    {
        json["md_J"].push_back(
            {{"t", number_json(J.t)}, {"mean", number_json(J.mean)}, {"interpolation_error", number_json(J.error)}});
    }
    json["summary"] = row.state.numbers;
    return json;
}

} // namespace

std::string sweep_csv(const SweepTable& table)
{
    std::string text = "number,name";
    for (const SweepAxis& axis : table.sweep.axes)
    {
        text += fmt::format(",{}", fmt::join(axis.keys, ","));
    }
    text += ",status,wall_s,step_s,steps,t";
    for (const SweepMeasure& measure : table.sweep.measures)
    {
        text += ',';
        text += csv_field(measure.text);
    }
    for (std::size_t k = 0; k < comparison_count(table.sweep); ++k)
    {
        const std::string at = table.sweep.compare_t.empty() ? "" : fmt::format("@{}", table.sweep.compare_t[k]);
        text += fmt::format(",md_J{0},md_J_t{0},md_J_interpolation_error{0}", at);
    }
    text += ",reference,folder,reason\n";
    for (const SweepRow& row : table.rows)
    {
        const SweepRun& run = table.runs[row.run];
        text += fmt::format("{},{}", row.run + 1, csv_field(run.name));
        for (std::size_t i = 0; i < table.sweep.axes.size(); ++i)
        {
            for (const config::Value& value : table.sweep.axes[i].values[run.at[i]])
            {
                text += ',';
                text += csv_field(plain_text(value));
            }
        }
        text += "," + row.state.status;
        std::vector<double> numbers{row.number("wall_s"), row.step_s(), row.number("steps"), row.number("t")};
        numbers.insert(numbers.end(), row.measures.begin(), row.measures.end());
        for (std::size_t k = 0; k < comparison_count(table.sweep); ++k)
        {
            const JDifference J = k < row.J.size() ? row.J[k] : JDifference{};
            numbers.insert(numbers.end(), {J.mean, J.t, J.error});
        }
        for (const double value : numbers)
        {
            text += ',';
            text += csv_number(value);
        }
        text += fmt::format(",{},{},{}\n", csv_field(row.reference), csv_field(row.folder.string()),
                            csv_field(row.state.reason));
    }
    return text;
}

std::string sweep_markdown(const SweepTable& table, const study::Pictures& pictures)
{
    std::string text = fmt::format("# {}\n\n{} runs of `{}`", study::markdown_cell(table.sweep.title),
                                   table.runs.size(), table.sweep.base.filename().string());
    if (!table.sweep.settings.empty())
    {
        text += fmt::format(" with `{}`", fmt::join(table.sweep.settings, "`, `"));
    }
    text += ". Durations are wall times, everything included; a step is their mean over the steps since the run was "
            "last started.\n\n";
    text += runs_table(table) + reference_text(table) + failures(table) + warnings(table);
    for (const std::string& file : pictures.files)
    {
        text += fmt::format("![{}]({})\n\n", file, file);
    }
    return text + (pictures.reason.empty() ? "" : "No pictures: " + pictures.reason + "\n");
}

std::string sweep_json(const SweepTable& table, const study::Pictures& pictures)
{
    Json json;
    json["title"] = table.sweep.title;
    json["base"] = table.sweep.base.string();
    json["settings"] = table.sweep.settings;
    json["axes"] = Json::array();
    for (const SweepAxis& axis : table.sweep.axes)
    {
        json["axes"].push_back({{"keys", axis.keys}, {"names", axis.names}});
    }
    json["runs"] = Json::array();
    for (const SweepRow& row : table.rows)
    {
        json["runs"].push_back(row_json(table, row));
    }
    json["pictures"] = pictures.files;
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace corticle::sweep
