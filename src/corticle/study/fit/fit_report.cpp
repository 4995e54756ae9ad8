// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/version.hpp"
#include "corticle/study/fit/fit_result.hpp"
#include "corticle/study/markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace corticle::fit
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr double wide = 0.7; // sd over that of the prior from which on the targets say little
constexpr double strong_correlation = 0.8;
constexpr double good_mixing = 1.05;
constexpr double good_predictivity = 0.8;

Json interval_json(const Interval& interval)
{
    return {{"median", interval.median}, {"low", interval.low}, {"high", interval.high}, {"sd", interval.sd}};
}

Json parameters_json(const FitFile& fit, const FitResult& result)
{
    Json list = Json::array();
    for (std::size_t k = 0; k < fit.space.size(); ++k)
    {
        const FreeParameter& one = fit.space.parameters[k];
        Json json{{"key", one.key},
                  {"unit", one.unit},
                  {"bounds", {one.low, one.high}},
                  {"scale", one.is_log ? "log" : "linear"},
                  {"prior", one.is_normal ? "normal" : "uniform"},
                  {"best", result.evaluations[result.best].values[k]}};
        if (result.knowledge)
        {
            json["mode"] = one.value(result.knowledge->mode[k]);
            json["posterior"] = interval_json(result.knowledge->parameters[k]);
            json["posterior"]["low_together"] = result.knowledge->together[k].low;
            json["posterior"]["high_together"] = result.knowledge->together[k].high;
            json["variance_share_of_surrogate"] = result.knowledge->of_emulator(static_cast<Eigen::Index>(k));
            json["sd_over_prior"] = result.knowledge->narrowed[k];
            json["r_hat"] = result.knowledge->draws.mixing[k];
        }
        list.push_back(json);
    }
    return list;
}

Json quantities_json(const FitFile& fit, const FitResult& result)
{
    Json list = Json::array();
    const std::vector<Quantity> quantities = fit.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        Json json{{"name", quantities[q].name()}};
        if (quantities[q].value)
        {
            json["observed"] = *quantities[q].value;
            json["sd"] = quantities[q].sd;
        }
        json["best"] = result.evaluations[result.best].predicted[q];
        if (result.knowledge)
        {
            const Knowledge& known = *result.knowledge;
            const auto row = static_cast<Eigen::Index>(q);
            json["by_parameters"] = interval_json(known.certain[q]);
            json["of_a_run"] = interval_json(known.expected[q]);
            json["predictivity"] = known.emulator.processes()[q].predictivity();
            json["scatter"] = known.emulator.processes()[q].scatter();
            json["correction"] = known.emulator.correction()(row);
            json["correction_sd"] = std::sqrt(known.emulator.correction_variance()(row));
        }
        list.push_back(json);
    }
    return list;
}

std::string parameters_table(const FitFile& fit, const FitResult& result)
{
    std::string text =
        "| parameter | unit | bounds | best run | median | 90 % each | 90 % all together | sd over prior's | "
        "surrogate's share of its variance |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t k = 0; k < fit.space.size(); ++k)
    {
        const FreeParameter& one = fit.space.parameters[k];
        text += fmt::format("| `{}` | {} | {:g} to {:g}{} | {:.5g} |", one.key, one.unit, one.low, one.high,
                            one.is_log ? ", log" : "", result.evaluations[result.best].values[k]);
        if (result.knowledge)
        {
            const Interval& found = result.knowledge->parameters[k];
            const Interval& together = result.knowledge->together[k];
            text += fmt::format(" {:.5g} | {:.5g} to {:.5g} | {:.5g} to {:.5g} | {:.2f} | {:.0f} % |\n", found.median,
                                found.low, found.high, together.low, together.high, result.knowledge->narrowed[k],
                                100.0 * result.knowledge->of_emulator(static_cast<Eigen::Index>(k)));
        }
        else
        {
            text += " | | | | |\n";
        }
    }
    return text + "\n";
}

/// What the targets leave open, in words.
std::string cautions(const FitFile& fit, const Knowledge& known)
{
    std::string text;
    for (std::size_t k = 0; k < fit.space.size(); ++k)
    {
        if (known.narrowed[k] > wide)
        {
            text +=
                fmt::format("- **`{}` is hardly determined**: its uncertainty is {:.0f} % of what it was before the "
                            "targets were looked at.\n",
                            fit.space.parameters[k].key, 100.0 * known.narrowed[k]);
        }
        if (known.of_emulator(static_cast<Eigen::Index>(k)) > fit.surrogate.share)
        {
            text += fmt::format("- The surrogate's errors make {:.0f} % of the variance of `{}`: more `refinements`.\n",
                                100.0 * known.of_emulator(static_cast<Eigen::Index>(k)), fit.space.parameters[k].key);
        }
        if (known.draws.mixing[k] > good_mixing)
        {
            text += fmt::format("- The chains do not agree on `{}` (R-hat {:.2f}): more `samples`.\n",
                                fit.space.parameters[k].key, known.draws.mixing[k]);
        }
        for (std::size_t j = 0; j < k; ++j)
        {
            const double r = known.correlations(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
            if (std::abs(r) > strong_correlation)
            {
                text += fmt::format("- **`{}` and `{}` trade off** (correlation {:.2f}): the targets determine a "
                                    "combination of them, not each.\n",
                                    fit.space.parameters[j].key, fit.space.parameters[k].key, r);
            }
        }
    }
    const std::vector<Quantity> quantities = fit.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        const double predictivity = known.emulator.processes()[q].predictivity();
        if (predictivity < good_predictivity)
        {
            text += fmt::format("- The surrogate of {} is poor (Q² {:.2f}): runs scatter by {:.3g}, or more points are "
                                "needed.\n",
                                quantities[q].name(), predictivity, known.emulator.processes()[q].scatter());
        }
    }
    return text.empty() ? "" : text + "\n";
}

std::string correlations_table(const FitFile& fit, const Knowledge& known)
{
    std::string text = "| correlation |";
    std::string line = "|---|";
    for (const FreeParameter& one : fit.space.parameters)
    {
        text += fmt::format(" `{}` |", one.name());
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (std::size_t i = 0; i < fit.space.size(); ++i)
    {
        text += fmt::format("| `{}` |", fit.space.parameters[i].name());
        for (std::size_t j = 0; j < fit.space.size(); ++j)
        {
            text += fmt::format(" {:.2f} |",
                                known.correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        }
        text += "\n";
    }
    return text + "\n";
}

std::string targets_table(const FitFile& fit, const FitResult& result)
{
    std::string text =
        "| quantity | observed | sd | best run | (best - observed) / sd | 90 % by parameters | 90 % of a run | "
        "Q² | correction |\n|---|---|---|---|---|---|---|---|---|\n";
    const std::vector<Quantity> quantities = fit.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        const Quantity& one = quantities[q];
        const double best = result.evaluations[result.best].predicted[q];
        text += fmt::format("| {} | {} | {} | {:.5g} | {} |", study::markdown_cell(one.name()),
                            one.value ? fmt::format("{:.5g}", *one.value) : "",
                            one.value ? fmt::format("{:.3g}", one.sd) : "", best,
                            one.value ? fmt::format("{:.2f}", (best - *one.value) / one.sd) : "");
        if (result.knowledge)
        {
            const Knowledge& known = *result.knowledge;
            text += fmt::format(" {:.5g} to {:.5g} | {:.5g} to {:.5g} | {:.3f} | {:.3g} |\n", known.certain[q].low,
                                known.certain[q].high, known.expected[q].low, known.expected[q].high,
                                known.emulator.processes()[q].predictivity(),
                                known.emulator.correction()(static_cast<Eigen::Index>(q)));
        }
        else
        {
            text += " | | | |\n";
        }
    }
    return text + "\n";
}

} // namespace

std::string fit_json(const FitFile& fit, const FitResult& result)
{
    const Evaluation& best = result.evaluations[result.best];
    Json json{{"title", fit.study.title}, {"base", fit.study.base.string()}, {"seed", fit.study.seed}};
    json["search"] = fit.search ? Json(fit.search->method) : Json();
    json["evaluations"] = result.evaluations.size();
    json["failed"] =
        std::ranges::count_if(result.evaluations, [](const Evaluation& one) { return !one.failure.empty(); });
    json["best"] = {
        {"number", result.best + 1}, {"stage", best.stage}, {"folder", best.folder}, {"misfit", misfit(fit, best)}};
    json["parameters"] = parameters_json(fit, result);
    json["quantities"] = quantities_json(fit, result);
    if (result.knowledge)
    {
        const Knowledge& known = *result.knowledge;
        json["correlations"] = Json::array();
        for (Eigen::Index i = 0; i < known.correlations.rows(); ++i)
        {
            Json row = Json::array();
            for (Eigen::Index j = 0; j < known.correlations.cols(); ++j)
            {
                row.push_back(known.correlations(i, j));
            }
            json["correlations"].push_back(row);
        }
        json["posterior"] = {{"method", known.draws.is_laplace ? "laplace" : "walk"},
                             {"draws", known.draws.points.size()},
                             {"acceptance", known.draws.acceptance},
                             {"surrogate_runs", known.emulator.runs()}};
    }
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string fit_markdown(const FitFile& fit, const FitResult& result)
{
    const Evaluation& best = result.evaluations[result.best];
    const auto failed =
        std::ranges::count_if(result.evaluations, [](const Evaluation& one) { return !one.failure.empty(); });
    std::string text = fmt::format(
        "# {}\n\n{} runs of `{}`, {} of them failed ([evaluations.csv](evaluations.csv)). The "
        "best, number {} ({}), misses {} targets by a misfit of {:.4g}; its case is "
        "[best.toml](best.toml).\n\n",
        study::markdown_cell(fit.study.title), result.evaluations.size(), fit.study.base.filename().string(), failed,
        result.best + 1, best.stage, fit.targets.size(), misfit(fit, best));
    text += parameters_table(fit, result);
    if (result.knowledge)
    {
        text += cautions(fit, *result.knowledge) + correlations_table(fit, *result.knowledge);
    }
    text += targets_table(fit, result);
    for (const auto& [name, content] : fit_plots(fit, result))
    {
        text += fmt::format("![{}]({})\n\n", name, name);
    }
    return text;
}

} // namespace corticle::fit
