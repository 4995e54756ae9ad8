// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/real_comparison.hpp"
#include "corticle/view/pictures.hpp"

#include "corticle/base/version.hpp"
#include "corticle/config/parameters/choices.hpp"
#include "corticle/metrics/comparison.hpp"
#include "corticle/study/markdown.hpp"
#include "corticle/view/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace corticle::study
{

namespace
{

constexpr const char* measures_plot = "measures.png";

using Json = nlohmann::ordered_json;

/// The run less the real surface, in percent or, of shares, as it is.
std::string shown_difference(const metrics::SurfaceRow& real, double run)
{
    return metrics::is_share(real.key) ? table_difference(run - real.value)
                                       : table_percent(metrics::telling_percent(real.key, real.value, run));
}

/// What reading the file noted and warned about.
std::string reading_lines(const RealSurface& real)
{
    std::string text;
    for (const std::string& note : real.notes)
    {
        text += fmt::format("- {}\n", markdown_cell(note));
    }
    for (const std::string& warning : real.warnings)
    {
        text += fmt::format("- Warning: {}\n", markdown_cell(warning));
    }
    return text.empty() ? text : text + "\n";
}

std::string real_section(const RealComparison& comparison, const RealSurface& real)
{
    std::string text = fmt::format("## {}\n\n", markdown_cell(real.name)) + reading_lines(real);
    if (std::isnan(comparison.run_value(0, real)))
    {
        text += fmt::format("The run does not reach this surface's {}.\n\n", comparison.axis);
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < real.rows.size(); ++k)
    {
        const double run = comparison.run_value(k, real);
        rows.push_back({fmt::format("`{}`", real.rows[k].key), real.rows[k].unit, table_number(real.rows[k].value),
                        table_number(run), shown_difference(real.rows[k], run)});
    }
    text += markdown_table({"measure", "unit", "real", "run", "run less real"}, rows);
    return real.pattern ? text + pattern_section(*real.pattern, comparison.axis) : text;
}

Json real_json(const RealComparison& comparison, const RealSurface& real)
{
    Json json;
    json["name"] = real.name;
    json[comparison.axis] = real.place;
    json["measures"] = Json::object();
    for (std::size_t k = 0; k < real.rows.size(); ++k)
    {
        const double run = comparison.run_value(k, real);
        json["measures"][real.rows[k].key] = {
            {"unit", real.rows[k].unit},
            {"real", real.rows[k].value},
            {"run", run},
            {"difference", run - real.rows[k].value},
            {"difference_percent", metrics::telling_percent(real.rows[k].key, real.rows[k].value, run)}};
    }
    if (real.pattern)
    {
        json["pattern"] = pattern_json(*real.pattern, comparison.axis);
    }
    json["notes"] = real.notes;
    json["warnings"] = real.warnings;
    return json;
}

/// The options of the command that say how files were read, so that they can be read again.
Json reading_json(const RealSurfaceOptions& reading)
{
    const auto name = [](auto value) { return config::names<decltype(value)>()[static_cast<std::size_t>(value)]; };
    return {{"unit", name(reading.unit)},
            {"coordinates", name(reading.coordinates)},
            {"labels", reading.mask.labels},
            {"closing_mm", reading.mask.closing_mm},
            {"smoothing_mm", reading.mask.smoothing_mm}};
}

std::vector<view::Panel> panels_of(const RealComparison& comparison)
{
    std::vector<view::Panel> panels;
    for (std::size_t k = 0; k < comparison.reals.front().rows.size(); ++k)
    {
        const metrics::SurfaceRow& row = comparison.reals.front().rows[k];
        view::Curve run{"run", comparison.places, {}};
        for (const std::vector<metrics::SurfaceRow>& rows : comparison.run_rows)
        {
            run.y.push_back(rows[k].value);
        }
        view::Curve reals{"real", {}, {}, true};
        for (const RealSurface& real : comparison.reals)
        {
            reals.x.push_back(real.place);
            reals.y.push_back(real.rows[k].value);
        }
        panels.push_back({comparison.axis == "week" ? "gestational week" : "growth time t",
                          view::titled(row.key, row.unit),
                          {std::move(run), std::move(reals)}});
    }
    return panels;
}

} // namespace

std::vector<std::string> comparison_pictures(const RealComparison& /*comparison*/)
{
    return {measures_plot};
}

void draw_comparison(const std::filesystem::path& folder, const RealComparison& comparison)
{
    view::render_plot(folder / measures_plot, panels_of(comparison), comparison.run_name + " beside real surfaces");
}

std::string comparison_json(const RealComparison& comparison, const Pictures& pictures)
{
    Json json;
    json["kind"] = "real";
    json["run"] = {{"name", comparison.run_name}, {"folder", comparison.run_folder.string()}};
    json["reading"] = reading_json(comparison.reading);
    json["axis"] = comparison.axis;
    json[comparison.axis] = comparison.places;
    json["run_measures"] = Json::object();
    for (const std::vector<metrics::SurfaceRow>& rows : comparison.run_rows)
    {
        for (const metrics::SurfaceRow& row : rows)
        {
            json["run_measures"][row.key].push_back(row.value);
        }
    }
    json["reals"] = Json::array();
    for (const RealSurface& real : comparison.reals)
    {
        json["reals"].push_back(real_json(comparison, real));
    }
    json["pictures"] = pictures.files;
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparison_report(const RealComparison& comparison, const Pictures& pictures)
{
    std::string text = fmt::format(
        "# {} beside real surfaces\n\nRun folder: {}. Its surfaces, {} output times from {} = {} to {}, and the real "
        "ones "
        "are measured by the same functions. Between its output times the run is interpolated linearly. Differences "
        "are those of the run from the real surface, over the real one; of shares and asymmetries they are plain "
        "differences, and over what is near zero there is none.\n\n",
        markdown_cell(comparison.run_name), markdown_cell(comparison.run_folder.string()), comparison.places.size(),
        comparison.axis, table_number(comparison.places.front()), table_number(comparison.places.back()));
    for (const RealSurface& real : comparison.reals)
    {
        text += real_section(comparison, real);
    }
    return text + (pictures.files.empty() ? fmt::format("No plot was drawn: {}\n", pictures.reason)
                                          : fmt::format("![Measures against {}](measures.png)\n", comparison.axis));
}

std::string comparison_summary(const RealComparison& comparison)
{
    std::string text;
    for (const RealSurface& real : comparison.reals)
    {
        text +=
            fmt::format("{} ({} {}): real, run, run less real\n", real.name, comparison.axis, table_number(real.place));
        for (std::size_t k = 0; k < real.rows.size(); ++k)
        {
            const double run = comparison.run_value(k, real);
            text += fmt::format("  {:<20}{:>12}{:>12}   {}\n", real.rows[k].key, table_number(real.rows[k].value),
                                table_number(run), shown_difference(real.rows[k], run));
        }
        text += real.pattern ? pattern_lines(*real.pattern) : "";
    }
    return text;
}

} // namespace corticle::study
