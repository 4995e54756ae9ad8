// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/sweep_report.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/report/body.hpp"
#include "corticle/report/plain_text.hpp"
#include "corticle/report/run_facts.hpp"
#include "corticle/report/sources.hpp"

#include <fmt/format.h>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* numbers_file = "sweep.json";
constexpr std::size_t most_bodies = 60; ///< as many as surfaces.png has
constexpr double bytes_of_scripts = 1.1e6;

/// A value of a case; texts that name files without their folders.
Json shown_value(const Json& value)
{
    return value.is_string() ? Json(without_paths(value.get<std::string>())) : value;
}

Json axes_json(const Json& sweep)
{
    Json axes = Json::array();
    for (const Json& axis : sweep.at("axes"))
    {
        for (const Json& key : axis.at("keys"))
        {
            const config::Parameter* const parameter = config::find_parameter(key.get<std::string>());
            axes.push_back({{"key", key}, {"unit", parameter == nullptr ? "" : unit_text(parameter->unit)}});
        }
    }
    return axes;
}

Json run_json(const Json& run)
{
    Json values = Json::object();
    for (const auto& [key, value] : run.at("values").items())
    {
        values[key] = shown_value(value);
    }
    Json numbers = run.at("measures");
    for (const auto& [key, value] : run.at("summary").items())
    {
        if (value.is_number() && !numbers.contains(key))
        {
            numbers[key] = value;
        }
    }
    const Json reason = run.value("reason", Json(nullptr));
    Json warnings = Json::array();
    for (const Json& warning : run.value("warnings", Json::array()))
    {
        warnings.push_back(without_paths(warning.get<std::string>()));
    }
    return {{"name", run.at("name")},
            {"values", std::move(values)},
            {"status", run.at("status")},
            {"reason", reason.is_string() ? without_paths(reason.get<std::string>()) : std::string()},
            {"warnings", std::move(warnings)},
            {"numbers", std::move(numbers)},
            {"body", nullptr}};
}

/// Labels of all numbers of the runs.
Json labels_of(const Json& runs)
{
    Json labels = Json::object();
    for (const Json& run : runs)
    {
        for (const auto& [key, value] : run.at("numbers").items())
        {
            labels[key] = label_of(key);
        }
    }
    return labels;
}

/// The body at the last output time of a run; none where it has none.
std::vector<Body> last_body(const fs::path& folder, const std::string& name)
{
    try
    {
        const record::RunContents run = record::read_run(folder);
        const std::array chosen{run.frames.size() - 1};
        return {read_body(run, chosen, name)};
    }
    catch (const InputError&)
    {
        return {};
    }
}

} // namespace

bool is_sweep(const fs::path& folder)
{
    return is_there(folder / numbers_file);
}

Page sweep_page(const ReportRequest& request)
{
    const Json sweep = read_json(request.folder / numbers_file);
    const std::string title = without_paths(sweep.value("title", std::string()));
    Page page{title,
              fmt::format("{}: {} simulations of cortical folding with Corticle.", title, sweep.at("runs").size()),
              {},
              {}};
    std::vector<Body> bodies;
    Json runs = Json::array();
    for (const Json& run : sweep.at("runs"))
    {
        Json entry = run_json(run);
        if (bodies.size() < most_bodies)
        {
            for (Body& body :
                 last_body(request.folder / run.at("folder").get<std::string>(), run.at("name").get<std::string>()))
            {
                entry["body"] = bodies.size();
                bodies.push_back(std::move(body));
            }
        }
        runs.push_back(std::move(entry));
    }
    std::vector<std::string> notes;
    if (sweep.at("runs").size() > most_bodies)
    {
        notes.push_back(fmt::format("The grid shows the first {} runs; the table has all.", most_bodies));
    }
    const auto most = static_cast<std::size_t>(std::max(1e6 * request.megabytes - bytes_of_scripts, 0.0));
    page.content = {
        {"kind", "sweep"}, {"title", title}, {"axes", axes_json(sweep)}, {"labels", labels_of(runs)}, {"runs", runs}};
    page.content["measures"] = Json::array();
    const Json measures = sweep.at("runs").empty() ? Json::object() : sweep.at("runs").front().at("measures");
    for (const auto& [key, value] : measures.items())
    {
        page.content["measures"].push_back(key);
    }
    page.content["settings"] = Json::array();
    for (const Json& setting : sweep.value("settings", Json::array()))
    {
        page.content["settings"].push_back(without_paths(setting.get<std::string>()));
    }
    page.content["bodies"] = bodies.empty() ? Json::array() : pack_bodies(std::move(bodies), most, page.blobs, notes);
    page.content["notes"] = notes;
    page.content["maps"] = color_maps_json();
    page.content["scalars"] = scalars_json();
    page.content["version"] = sweep.value("version", std::string());
    return page;
}

} // namespace corticle::report
