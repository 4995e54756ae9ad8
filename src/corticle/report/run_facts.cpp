// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/run_facts.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/report/methods_text.hpp"
#include "corticle/report/plain_text.hpp"
#include "corticle/view/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

/// Keys of summary.json that say what a run took.
constexpr std::array timings{"wall_s",    "internal_forces_s", "contact_s", "measures_s",     "output_s",
                             "steps",     "rejected_steps",    "threads",   "peak_memory_mb", "us_per_particle_step",
                             "particles", "elements"};

std::string_view group_of(std::string_view key)
{
    const auto begins = [&](std::string_view word) { return key.starts_with(word); };
    if (begins("energy") || begins("work") || key.ends_with("_share") || begins("residual"))
    {
        return "Energy and balance";
    }
    if (begins("gi_") || begins("sulcal") || begins("gyral") || begins("fold") || begins("abs_mean") ||
        begins("curvedness") || begins("curved_gi") || begins("asymmetry"))
    {
        return "Folds";
    }
    if (begins("area") || begins("volume") || begins("curved") || begins("hull") || key == "length_mm" ||
        key == "width_mm" || key == "height_mm" || begins("thickness") || begins("length_scale"))
    {
        return "Size";
    }
    return begins("J_") ? "Tissue" : "Steps and checks";
}

Json warnings_of(const fs::path& log)
{
    Json lines = Json::array();
    std::ifstream stream(log);
    constexpr std::string_view mark = "[warning] ";
    for (std::string line; std::getline(stream, line);)
    {
        if (const std::size_t at = line.find(mark); at != std::string::npos)
        {
            lines.push_back(without_paths(line.substr(at + mark.size())));
        }
    }
    return lines;
}

std::string shown_value(const config::Parameter& parameter, const config::Value& value)
{
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr && parameter.is_path && !text->empty() ? name_of(*text)
                                                                  : without_paths(config::toml_text(value));
}

Json case_json(const config::Options& options)
{
    const config::Options defaults = config::default_options();
    Json rows = Json::array();
    for (const config::Parameter& parameter : config::parameters())
    {
        const config::Value value = parameter.get(options);
        const std::string text = shown_value(parameter, value);
        rows.push_back({{"section", parameter.section()},
                        {"key", parameter.name()},
                        {"value", text},
                        {"unit", unit_text(parameter.unit)},
                        {"sentence", parameter.sentence},
                        {"changed", text != shown_value(parameter, parameter.get(defaults))}});
    }
    return rows;
}

Json inputs_of(const Json& summary)
{
    Json rows = Json::array();
    const Json inputs = summary.value("inputs", Json::object());
    for (const auto& [key, input] : inputs.items())
    {
        rows.push_back({{"key", key},
                        {"file", name_of(input.value("file", std::string()))},
                        {"sha256", input.value("sha256", std::string())}});
    }
    return rows;
}

} // namespace

Json read_summary(const fs::path& folder)
{
    std::ifstream stream(folder / "summary.json");
    Json summary = Json::parse(stream, nullptr, false);
    return summary.is_object() ? summary : Json::object();
}

Json measures_json(const formats::NumberTable& measures)
{
    Json rows = Json::array();
    const auto known = metrics::measure_columns();
    for (const formats::NumberColumn& column : measures.columns)
    {
        const auto entry = std::ranges::find(known, column.key, &metrics::MeasureColumn::key);
        rows.push_back({{"key", column.key},
                        {"label", label_of(column.key)},
                        {"unit", unit_text(column.unit)},
                        {"sentence", entry == known.end() ? std::string() : std::string(entry->sentence)},
                        {"group", group_of(column.key)},
                        {"values", column.values}});
    }
    return rows;
}

Json facts_json(const fs::path& folder, const Json& summary)
{
    Json facts;
    facts["status"] = summary.value("status", "no summary");
    facts["reason"] = without_paths(summary.value("reason", std::string()));
    facts["version"] = summary.value("version", std::string());
    facts["versions"] = summary.value("versions", std::string());
    facts["onset_t"] = summary.value("onset_t", Json(nullptr));
    facts["timing"] = Json::array();
    for (const char* key : timings)
    {
        if (summary.contains(key))
        {
            facts["timing"].push_back({{"key", key}, {"label", label_of(key)}, {"value", summary[key]}});
        }
    }
    facts["inputs"] = inputs_of(summary);
    facts["warnings"] = warnings_of(folder / "run.log");
    try
    {
        const config::Options options = config::read_case(folder / "case.toml", {});
        facts["case"] = case_json(options);
        facts["methods"] = methods_text(options, summary);
    }
    catch (const InputError& error)
    {
        facts["case"] = Json::array();
        facts["warnings"].push_back(without_paths(error.what()));
    }
    return facts;
}

Json scalars_json()
{
    Json json = Json::object();
    for (const view::Scalar& scalar : view::known_scalars())
    {
        json[std::string(scalar.key)] = {{"label", label_of(scalar.key)},
                                         {"unit", unit_text(scalar.unit)},
                                         {"sentence", scalar.sentence},
                                         {"map", view::name_of(scalar.map)}};
    }
    return json;
}

Json color_maps_json()
{
    using view::ColorMap;
    Json json = Json::object();
    for (const ColorMap map :
         {ColorMap::viridis, ColorMap::viridis_reversed, ColorMap::cividis, ColorMap::blue_orange, ColorMap::grey})
    {
        Json colors = Json::array();
        for (int k = 0; k <= 32; ++k)
        {
            const view::Color color = view::map_color(map, k / 32.0);
            colors.push_back(
                {std::lround(255.0 * color[0]), std::lround(255.0 * color[1]), std::lround(255.0 * color[2])});
        }
        json[view::name_of(map)] = std::move(colors);
    }
    return json;
}

} // namespace corticle::report
