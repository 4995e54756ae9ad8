// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/sensitivity_report.hpp"

#include "corticle/base/version.hpp"
#include "corticle/study/fit/svg_plot.hpp"
#include "corticle/study/markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace corticle::sensitivity
{

namespace
{

using Json = nlohmann::ordered_json;
using fit::SvgMarks;
using fit::SvgPanel;
using Kind = SvgMarks::Kind;

constexpr double good_predictivity = 0.8;
constexpr const char* first_colour = "#1f5fa8";
constexpr const char* total_colour = "#9db8d9";

Json measure_json(const SensitivityFile& file, const fit::Quantity& quantity, const MeasureSensitivity& found)
{
    Json json{{"name", quantity.name()}, {"parameters", Json::array()}};
    for (std::size_t k = 0; k < file.space.size(); ++k)
    {
        Json one{{"key", file.space.parameters[k].key}};
        if (!found.effects.empty())
        {
            const ElementaryEffects& effects = found.effects[k];
            one["mu_star"] = effects.mean_magnitude;
            one["mu_star_error"] = effects.error;
            one["mu"] = effects.mean;
            one["sigma"] = effects.deviation;
            one["effects"] = effects.count;
        }
        if (found.sobol)
        {
            one["first"] = found.sobol->indices.first[k];
            one["first_error"] = found.sobol->first_error[k];
            one["total"] = found.sobol->indices.total[k];
            one["total_error"] = found.sobol->total_error[k];
        }
        json["parameters"].push_back(one);
    }
    if (found.sobol)
    {
        json["predictivity"] = found.sobol->predictivity;
        json["scatter_share"] = found.sobol->scatter_share;
    }
    return json;
}

std::string measure_table(const SensitivityFile& file, const MeasureSensitivity& found)
{
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < file.space.size(); ++k)
    {
        std::vector<std::string> row{fmt::format("`{}`", file.space.parameters[k].key), "-", "-", "-", "-"};
        if (!found.effects.empty())
        {
            row[1] = fmt::format("{:.4g} ± {:.2g}", found.effects[k].mean_magnitude, found.effects[k].error);
            row[2] = fmt::format("{:.3g}", found.effects[k].deviation);
        }
        if (found.sobol)
        {
            row[3] = fmt::format("{:.3f} ± {:.3f}", found.sobol->indices.first[k], found.sobol->first_error[k]);
            row[4] = fmt::format("{:.3f} ± {:.3f}", found.sobol->indices.total[k], found.sobol->total_error[k]);
        }
        rows.push_back(row);
    }
    return study::markdown_table({"parameter", "mu*", "sigma", "first", "total"}, rows);
}

std::vector<std::string> parameter_names(const SensitivityFile& file)
{
    std::vector<std::string> names;
    for (const fit::FreeParameter& one : file.space.parameters)
    {
        names.push_back(one.name());
    }
    return names;
}

/// Two bars beside each other for each parameter, with their 90 % intervals.
SvgPanel sobol_panel(const SensitivityFile& file, const std::string& name, const EmulatedIndices& found)
{
    SvgPanel panel{name, "", "share of the variance", false, {}, parameter_names(file)};
    const auto add =
        [&](const std::vector<double>& values, const std::vector<double>& errors, double from, const char* colour)
    {
        SvgMarks bars{Kind::bars, {}, {}, {}, {}, colour, 1.0};
        SvgMarks whiskers{Kind::whiskers, {}, {}, {}, {}, "#222222", 1.0};
        for (std::size_t k = 0; k < values.size(); ++k)
        {
            const double x = static_cast<double>(k) + from;
            bars.x.push_back(x);
            bars.x_high.push_back(x + 0.3);
            bars.y.push_back(values[k]);
            whiskers.x.push_back(x + 0.15);
            whiskers.y.push_back(values[k] - errors[k]);
            whiskers.y_high.push_back(values[k] + errors[k]);
        }
        panel.marks.push_back(bars);
        panel.marks.push_back(whiskers);
    };
    add(found.indices.first, found.first_error, -0.32, first_colour);
    add(found.indices.total, found.total_error, 0.02, total_colour);
    return panel;
}

SvgPanel morris_panel(const SensitivityFile& file, const std::string& name,
                      const std::vector<ElementaryEffects>& effects)
{
    SvgPanel panel{name, "", "mu*, 90 %", false, {}, parameter_names(file)};
    SvgMarks bars{Kind::bars, {}, {}, {}, {}, first_colour, 1.0};
    SvgMarks whiskers{Kind::whiskers, {}, {}, {}, {}, "#222222", 1.0};
    for (std::size_t k = 0; k < effects.size(); ++k)
    {
        const auto x = static_cast<double>(k);
        bars.x.push_back(x - 0.2);
        bars.x_high.push_back(x + 0.2);
        bars.y.push_back(effects[k].mean_magnitude);
        whiskers.x.push_back(x);
        whiskers.y.push_back(effects[k].mean_magnitude - effects[k].error);
        whiskers.y_high.push_back(effects[k].mean_magnitude + effects[k].error);
    }
    panel.marks = {bars, whiskers};
    return panel;
}

} // namespace

std::vector<std::pair<std::string, std::string>> sensitivity_plots(const SensitivityFile& file,
                                                                   const Findings& findings)
{
    std::vector<SvgPanel> morris;
    std::vector<SvgPanel> sobol;
    for (std::size_t m = 0; m < file.measures.size(); ++m)
    {
        const MeasureSensitivity& found = findings.measures[m];
        const std::string name = file.measures[m].name();
        if (!found.effects.empty())
        {
            morris.push_back(morris_panel(file, name, found.effects));
        }
        if (found.sobol)
        {
            sobol.push_back(sobol_panel(file, name, *found.sobol));
        }
    }
    std::vector<std::pair<std::string, std::string>> plots;
    if (!morris.empty())
    {
        plots.emplace_back("plots/morris.svg", svg_plot(morris, 3));
    }
    if (!sobol.empty())
    {
        plots.emplace_back("plots/sobol.svg", svg_plot(sobol, 3));
    }
    return plots;
}

std::string sensitivity_json(const SensitivityFile& file, const Findings& findings)
{
    Json json{{"title", file.study.title}, {"base", file.study.base.string()}, {"seed", file.study.seed}};
    json["evaluations"] = findings.evaluations.size();
    json["failed"] =
        std::ranges::count_if(findings.evaluations, [](const fit::Evaluation& one) { return !one.failure.empty(); });
    json["parameters"] = Json::array();
    for (const fit::FreeParameter& one : file.space.parameters)
    {
        json["parameters"].push_back({{"key", one.key},
                                      {"unit", one.unit},
                                      {"bounds", {one.low, one.high}},
                                      {"scale", one.is_log ? "log" : "linear"}});
    }
    json["measures"] = Json::array();
    for (std::size_t m = 0; m < file.measures.size(); ++m)
    {
        json["measures"].push_back(measure_json(file, file.measures[m], findings.measures[m]));
    }
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string sensitivity_markdown(const SensitivityFile& file, const Findings& findings)
{
    const auto failed =
        std::ranges::count_if(findings.evaluations, [](const fit::Evaluation& one) { return !one.failure.empty(); });
    std::string text =
        fmt::format("# {}\n\n{} runs of `{}`, {} of them failed ([evaluations.csv](evaluations.csv)). mu* is the "
                    "mean change of the measure over the range of a parameter (Morris), first and total are "
                    "its shares of the variance, alone and with all its interactions (Sobol); ± half of the "
                    "90 % interval.\n\n",
                    study::markdown_cell(file.study.title), findings.evaluations.size(),
                    file.study.base.filename().string(), failed);
    for (std::size_t m = 0; m < file.measures.size(); ++m)
    {
        const MeasureSensitivity& found = findings.measures[m];
        text += "## " + study::markdown_cell(file.measures[m].name()) + "\n\n" + measure_table(file, found);
        if (found.sobol)
        {
            text += fmt::format(
                "Surrogate: Q² = {:.3f}; {:.1f} % of the variance of runs is scatter that no parameter explains.{}\n\n",
                found.sobol->predictivity, 100.0 * found.sobol->scatter_share,
                found.sobol->predictivity < good_predictivity ? " **The indices are not to be trusted**: more points."
                                                              : "");
        }
    }
    for (const auto& [name, content] : sensitivity_plots(file, findings))
    {
        text += fmt::format("![{}]({})\n\n", name, name);
    }
    return text;
}

} // namespace corticle::sensitivity
