// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/comparison_report.hpp"

#include "corticle/report/comparison_bodies.hpp"
#include "corticle/report/plain_text.hpp"
#include "corticle/report/run_facts.hpp"
#include "corticle/report/sources.hpp"

#include <fmt/format.h>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* numbers_file = "comparison.json";
constexpr double bytes_of_scripts = 1.1e6;

Json run_rows(const Json& comparison)
{
    Json rows = Json::array();
    for (const auto& [key, a] : comparison.at("runs").at(0).items())
    {
        if (key != "folder" && key != "name")
        {
            rows.push_back({label_of(key), a, comparison.at("runs").at(1).value(key, Json(nullptr))});
        }
    }
    return rows;
}

/// Measures of two runs at their common times.
Json paired_measures(const Json& comparison)
{
    Json rows = Json::array();
    for (const auto& [key, pair] : comparison.at("measures").items())
    {
        rows.push_back({{"key", key},
                        {"label", label_of(key)},
                        {"unit", unit_text(pair.value("unit", std::string()))},
                        {"a", pair.at("a")},
                        {"b", pair.at("b")},
                        {"percent", pair.at("difference_percent")}});
    }
    return rows;
}

/// Measures of a run as curves and of real surfaces as points.
Json real_measures(const Json& comparison, const std::string& axis)
{
    Json rows = Json::array();
    for (const auto& [key, values] : comparison.at("run_measures").items())
    {
        Json row{{"key", key}, {"label", label_of(key)}, {"unit", ""}, {"values", values}, {"points", Json::array()}};
        for (const Json& real : comparison.at("reals"))
        {
            const Json measure = real.at("measures").value(key, Json::object());
            row["unit"] = unit_text(measure.value("unit", std::string()));
            row["points"].push_back({{"at", real.at(axis)},
                                     {"real", measure.value("real", Json(nullptr))},
                                     {"run", measure.value("run", Json(nullptr))},
                                     {"percent", measure.value("difference_percent", Json(nullptr))}});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The number of bytes that arrays may take.
std::size_t room(const ReportRequest& request)
{
    return static_cast<std::size_t>(std::max(1e6 * request.megabytes - bytes_of_scripts, 0.0));
}

Page page_of_runs(const ReportRequest& request, const Json& comparison)
{
    std::array<fs::path, 2> folders;
    std::array<std::string, 2> names;
    for (std::size_t k = 0; k < 2; ++k)
    {
        folders[k] = found_from(request.folder, comparison.at("runs").at(k).value("folder", std::string()));
        names[k] = without_paths(comparison.at("runs").at(k).value("name", std::string()));
    }
    const std::string title = fmt::format("{} and {}", names[0], names[1]);
    Page page{title, title + ": two simulations of cortical folding with Corticle, side by side.", {}, {}};
    page.content = {{"kind", "comparison"}, {"title", title}, {"names", names}, {"rows", run_rows(comparison)}};
    page.content["t"] = comparison.at("t");
    page.content["paired"] = paired_measures(comparison);
    page.content["frames"] = comparison.at("frames");
    page.content["version"] = comparison.value("version", std::string());
    std::vector<std::string> notes;
    page.content["pairs"] =
        Json::array({{{"label", title},
                      {"bodies", pack_bodies(bodies_of_runs(folders, names, comparison.at("frames")), room(request),
                                             page.blobs, notes)}}});
    page.content["notes"] = notes;
    return page;
}

Page page_of_reals(const ReportRequest& request, const Json& comparison)
{
    const std::string run = without_paths(comparison.value("run", Json::object()).value("name", std::string()));
    const std::string axis = comparison.value("axis", std::string("t"));
    Page page{
        run + " and real brains", run + ": a simulation of cortical folding with Corticle beside real brains.", {}, {}};
    page.content = {{"kind", "comparison"}, {"title", page.title}, {"axis", axis}, {"places", comparison.at(axis)}};
    page.content["measures"] = real_measures(comparison, axis);
    page.content["version"] = comparison.value("version", std::string());
    page.content["pairs"] = Json::array();
    std::vector<std::string> notes;
    const RealPairs pairs = bodies_of_reals(request.folder, comparison, notes);
    for (const RealPair& pair : pairs)
    {
        page.content["pairs"].push_back(
            {{"label", pair.label},
             {"distance", pair.distance},
             {"bodies", pack_bodies(pair.bodies, room(request) / pairs.size(), page.blobs, notes)}});
    }
    page.content["notes"] = notes;
    return page;
}

} // namespace

bool is_comparison(const fs::path& folder)
{
    return is_there(folder / numbers_file);
}

Page comparison_page(const ReportRequest& request)
{
    const Json comparison = read_json(request.folder / numbers_file);
    Page page = comparison.value("kind", std::string()) == "runs" ? page_of_runs(request, comparison)
                                                                  : page_of_reals(request, comparison);
    page.content["maps"] = color_maps_json();
    page.content["scalars"] = scalars_json();
    return page;
}

} // namespace corticle::report
