// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/run_comparison.hpp"

#include "corticle/base/version.hpp"
#include "corticle/study/markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace corticle::study
{

namespace
{

using Json = nlohmann::ordered_json;

/// The measures that the table against t shows; all of them stand in the table of the last time.
constexpr std::array main_measures{"area_ratio", "volume_ratio", "gi_hull", "gi_sphere", "J_min", "J_mean", "J_max"};

/// Of summary.json: what distinguishes two runs.
constexpr std::array described{"status",  "method", "particles", "elements", "spacing_mm", "neighbours_mean",
                               "onset_t", "steps",  "wall_s",    "threads",  "version"};

/// summary.json of a run; empty while the run goes on.
Json summary_of(const record::RunContents& run)
{
    std::ifstream stream(run.folder / "summary.json");
    Json summary = Json::parse(stream, nullptr, false);
    return summary.is_object() ? summary : Json::object();
}

std::string shown(const Json& value)
{
    if (value.is_string())
    {
        return markdown_cell(value.get<std::string>());
    }
    if (value.is_number_float())
    {
        return table_number(value.get<double>());
    }
    return value.is_null() ? "-" : markdown_cell(value.dump());
}

const MeasurePair* find_measure(const RunComparison& comparison, std::string_view key)
{
    const auto found = std::find_if(comparison.measures.begin(), comparison.measures.end(),
                                    [&](const MeasurePair& pair) { return pair.key == key; });
    return found == comparison.measures.end() ? nullptr : &*found;
}

std::array<std::string, 2> name_cells(const RunComparison& comparison)
{
    return {markdown_cell(comparison.names[0]), markdown_cell(comparison.names[1])};
}

std::string runs_section(const RunComparison& comparison)
{
    const auto names = name_cells(comparison);
    const std::array summaries{summary_of(comparison.runs[0]), summary_of(comparison.runs[1])};
    std::vector<std::vector<std::string>> rows{{"folder", markdown_cell(comparison.runs[0].folder.string()),
                                                markdown_cell(comparison.runs[1].folder.string())}};
    for (const char* key : described)
    {
        const auto value = [&](std::size_t run) { return shown(summaries[run].value(key, Json(nullptr))); };
        rows.push_back({fmt::format("`{}`", key), value(0), value(1)});
    }
    return "## Runs\n\n" + markdown_table({"", names[0], names[1]}, rows);
}

std::string times_table(const RunComparison& comparison)
{
    std::vector<std::string> header{"t"};
    std::vector<const MeasurePair*> shown_measures;
    for (const char* key : main_measures)
    {
        if (const MeasurePair* pair = find_measure(comparison, key))
        {
            header.push_back(fmt::format("`{}`", key));
            shown_measures.push_back(pair);
        }
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < comparison.times.size(); ++k)
    {
        rows.push_back({table_number(comparison.times[k])});
        for (const MeasurePair* pair : shown_measures)
        {
            rows.back().push_back(fmt::format("{} / {} ({})", table_number(pair->values[0][k]),
                                              table_number(pair->values[1][k]), pair->shown_difference(k)));
        }
    }
    return markdown_table(header, rows);
}

std::string last_table(const RunComparison& comparison)
{
    const auto names = name_cells(comparison);
    std::vector<std::vector<std::string>> rows;
    for (const MeasurePair& pair : comparison.measures)
    {
        rows.push_back({fmt::format("`{}`", pair.key), pair.unit, table_number(pair.values[0].back()),
                        table_number(pair.values[1].back()), pair.shown_difference(pair.percent.size() - 1)});
    }
    return markdown_table({"measure", "unit", names[0], names[1], "difference"}, rows);
}

std::string measures_section(const RunComparison& comparison, bool has_pictures)
{
    const auto names = name_cells(comparison);
    return fmt::format("## Measures\n\nEach cell: {} / {} (difference). Differences are those of the second run from "
                       "the first, over the first; of shares and asymmetries they are plain differences, and "
                       "over what is near zero there is none. Times are the output times of either run that both "
                       "cover; between "
                       "its output times a run is interpolated linearly.\n\n",
                       names[0], names[1]) +
           times_table(comparison) + fmt::format("All measures at t = {}:\n\n", table_number(comparison.times.back())) +
           last_table(comparison) + (has_pictures ? "![Measures against growth time](measures.png)\n\n" : "");
}

std::string how_J_is_compared(const RunComparison& comparison)
{
    const bool is_interpolated = std::any_of(comparison.frames.begin(), comparison.frames.end(),
                                             [](const FramePair& pair) { return pair.J.is_interpolated; });
    if (!is_interpolated)
    {
        return fmt::format("Both runs have the same {} reference points: J is compared directly, point by point.",
                           comparison.particles[0]);
    }
    return fmt::format(
        "The runs have different reference points ({} and {} particles): J is interpolated. Each point of either run "
        "is compared with the J of the other run interpolated in the reference configuration; the means over the "
        "points of each are averaged. *Interpolation error* is the mean error when each J is interpolated from its own "
        "neighbours: differences below it say nothing. *Compared* is the share of points with a counterpart.",
        comparison.particles[0], comparison.particles[1]);
}

std::string frames_section(const RunComparison& comparison)
{
    std::vector<std::vector<std::string>> rows;
    for (const FramePair& pair : comparison.frames)
    {
        rows.push_back({table_number(pair.files[0].t), table_number(pair.files[1].t), table_number(pair.J.mean),
                        table_number(pair.J.largest), table_number(pair.J.interpolation_error),
                        fmt::format("{:.4g} %", 100.0 * pair.J.compared_share), table_number(pair.surface.mean),
                        table_number(pair.surface.percentile_95), table_number(pair.surface.hausdorff)});
    }
    const auto names = name_cells(comparison);
    return fmt::format("## Point by point\n\nMD J is the mean of |J - J'| over the points (thesis eq. 27). {}\n\n"
                       "Distances [mm] go from the vertices of each deformed surface to the other surface, both ways "
                       "together.\n\n",
                       how_J_is_compared(comparison)) +
           markdown_table({fmt::format("t of {}", names[0]), fmt::format("t of {}", names[1]), "MD J", "largest",
                           "interpolation error", "compared", "mean distance", "95 %", "Hausdorff"},
                          rows);
}

std::string pictures_section(const Pictures& pictures)
{
    if (pictures.files.empty())
    {
        return fmt::format("## Pictures\n\nNone were drawn: {}\n", pictures.reason);
    }
    std::string text = "## Pictures\n\nBoth runs have one colour scale and one scale of length.\n";
    for (const std::string& file : pictures.files)
    {
        if (file != "measures.png")
        {
            text += fmt::format("\n![{}]({})\n", file, file);
        }
    }
    return text;
}

Json run_json(const RunComparison& comparison, std::size_t run)
{
    const Json summary = summary_of(comparison.runs[run]);
    Json json;
    json["name"] = comparison.names[run];
    json["folder"] = comparison.runs[run].folder.string();
    for (const char* key : described)
    {
        json[key] = summary.value(key, Json(nullptr));
    }
    json["particles"] = comparison.particles[run];
    return json;
}

Json frame_json(const FramePair& pair)
{
    Json json;
    json["t"] = {pair.files[0].t, pair.files[1].t};
    json["J_mean_difference"] = pair.J.mean;
    json["J_largest_difference"] = pair.J.largest;
    json["J_interpolated"] = pair.J.is_interpolated;
    json["J_interpolation_error"] = pair.J.interpolation_error;
    json["J_compared_share"] = pair.J.compared_share;
    json["surface_distance_mean_mm"] = pair.surface.mean;
    json["surface_distance_95_mm"] = pair.surface.percentile_95;
    json["surface_distance_hausdorff_mm"] = pair.surface.hausdorff;
    return json;
}

} // namespace

std::string MeasurePair::shown_difference(std::size_t time) const
{
    return metrics::is_share(key) ? table_difference(values[1][time] - values[0][time]) : table_percent(percent[time]);
}

std::string comparison_json(const RunComparison& comparison, const Pictures& pictures)
{
    Json json;
    json["kind"] = "runs";
    json["runs"] = {run_json(comparison, 0), run_json(comparison, 1)};
    json["t"] = comparison.times;
    json["measures"] = Json::object();
    for (const MeasurePair& pair : comparison.measures)
    {
        std::vector<double> difference;
        for (std::size_t k = 0; k < pair.percent.size(); ++k)
        {
            difference.push_back(pair.values[1][k] - pair.values[0][k]);
        }
        json["measures"][pair.key] = {{"unit", pair.unit},
                                      {"a", pair.values[0]},
                                      {"b", pair.values[1]},
                                      {"difference", difference},
                                      {"difference_percent", pair.percent}};
    }
    json["frames"] = Json::array();
    for (const FramePair& pair : comparison.frames)
    {
        json["frames"].push_back(frame_json(pair));
    }
    json["pictures"] = pictures.files;
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparison_report(const RunComparison& comparison, const Pictures& pictures)
{
    const auto names = name_cells(comparison);
    return fmt::format("# {} and {}\n\n", names[0], names[1]) + runs_section(comparison) +
           measures_section(comparison, !pictures.files.empty()) + frames_section(comparison) +
           pictures_section(pictures);
}

std::string comparison_summary(const RunComparison& comparison)
{
    std::string text = fmt::format("{} and {} at {} times up to t = {}\n", comparison.names[0], comparison.names[1],
                                   comparison.times.size(), table_number(comparison.times.back()));
    for (const char* key : main_measures)
    {
        if (const MeasurePair* pair = find_measure(comparison, key))
        {
            text += fmt::format("{:<20}{:>12}{:>12}   {}\n", key, table_number(pair->values[0].back()),
                                table_number(pair->values[1].back()), pair->shown_difference(pair->percent.size() - 1));
        }
    }
    const FramePair& last = comparison.frames.back();
    text +=
        fmt::format("mean difference of J at t = {}: {}{}\n", table_number(last.files[0].t), table_number(last.J.mean),
                    last.J.is_interpolated ? fmt::format(" (interpolated; the interpolation's own error: {})",
                                                         table_number(last.J.interpolation_error))
                                           : std::string(" (same points)"));
    return text + fmt::format("distance of the surfaces [mm]: mean {}, 95 % {}, Hausdorff {}\n",
                              table_number(last.surface.mean), table_number(last.surface.percentile_95),
                              table_number(last.surface.hausdorff));
}

} // namespace corticle::study
