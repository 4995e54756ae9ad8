// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/sensitivity.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/terminal.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/fit/evaluations_table.hpp"
#include "corticle/study/sensitivity/sensitivity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::sensitivity
{

namespace
{

namespace fs = std::filesystem;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Values of a measure; NaN of runs that failed.
std::vector<double> values_of(std::span<const fit::Evaluation> evaluations, std::size_t measure)
{
    std::vector<double> values;
    for (const fit::Evaluation& one : evaluations)
    {
        values.push_back(one.failure.empty() ? one.predicted[measure] : none);
    }
    return values;
}

std::vector<fit::Point> points_of(std::span<const fit::Evaluation> evaluations)
{
    std::vector<fit::Point> points;
    for (const fit::Evaluation& one : evaluations)
    {
        points.push_back(one.u);
    }
    return points;
}

/// By all runs that succeeded, those of the screening too.
EmulatedIndices sobol_of(const SensitivityFile& file, std::span<const fit::Evaluation> evaluations, std::size_t measure)
{
    std::vector<fit::Point> points;
    std::vector<double> values;
    for (const fit::Evaluation& one : evaluations)
    {
        if (one.failure.empty() && std::ranges::find(points, one.u) == points.end())
        {
            points.push_back(one.u);
            values.push_back(one.predicted[measure]);
        }
    }
    if (points.size() < 4 * (file.space.size() + 1))
    {
        throw RunError(fmt::format("{} of {} runs succeeded, too few for Sobol indices of {} parameters", points.size(),
                                   evaluations.size(), file.space.size()));
    }
    return emulated_indices(points, values, file.samples, file.study.seed);
}

Findings find(const SensitivityFile& file, fit::Evaluator& evaluator)
{
    Findings findings;
    std::vector<fit::Evaluation> screening;
    if (file.paths > 0)
    {
        screening =
            evaluator.evaluate(morris_paths(file.paths, file.space.size(), file.levels, file.study.seed), "morris");
    }
    findings.evaluations = screening;
    if (file.points > 0)
    {
        const std::vector<fit::Evaluation> design =
            evaluator.evaluate(fit::latin_hypercube(file.points, file.space.size(), file.study.seed), "design");
        findings.evaluations.insert(findings.evaluations.end(), design.begin(), design.end());
    }
    for (std::size_t m = 0; m < file.measures.size(); ++m)
    {
        MeasureSensitivity one;
        if (!screening.empty())
        {
            one.effects = elementary_effects(points_of(screening), values_of(screening, m));
        }
        if (file.points > 0)
        {
            one.sobol = sobol_of(file, findings.evaluations, m);
        }
        findings.measures.push_back(std::move(one));
    }
    return findings;
}

void write(const SensitivityFile& file, const Findings& findings, record::ResultFolder& folder)
{
    std::vector<std::pair<std::string, std::string>> texts = sensitivity_plots(file, findings);
    texts.emplace_back("evaluations.csv", fit::evaluations_table(file.space, file.measures, findings.evaluations, {}));
    texts.emplace_back("sensitivity.json", sensitivity_json(file, findings));
    texts.emplace_back("sensitivity.md", sensitivity_markdown(file, findings));
    std::vector<std::string> names;
    for (const auto& [name, text] : texts)
    {
        names.push_back(name);
    }
    folder.claim(names);
    for (const auto& [name, text] : texts)
    {
        formats::write_text_atomically(folder.path() / name, text);
    }
}

} // namespace

model::RunStatus analyze(const SensitivityRequest& request)
{
    const SensitivityFile file = read_sensitivity(request.file, request.overrides);
    const fs::path out = fs::absolute(request.out).lexically_normal();
    if (record::is_run_folder(out))
    {
        throw InputError(fmt::format("--out {}: holds a run; expected another folder for the analysis", out.string()));
    }
    record::ResultFolder folder(out, "sensitivity analysis");
    const std::vector<std::string> files{"evaluations.csv", "failures.json", "sensitivity.json", "sensitivity.md"};
    folder.require_free(files);
    folder.make();
    folder.remove_leftovers();
    folder.claim(files);
    fs::create_directories(out / "cases");
    fit::Evaluator evaluator(file.study.base, file.study.settings, file.space, file.measures,
                             {out, request.runs.empty() ? out / "runs" : fs::absolute(request.runs), request.command,
                              request.jobs, request.threads_per_run, request.quiet});
    try
    {
        write(file, find(file, evaluator), folder);
    }
    catch (const fit::Interrupted&)
    {
        return model::RunStatus::interrupted;
    }
    if (!request.quiet)
    {
        show(stdout, fmt::format("wrote {}\n", (out / "sensitivity.md").string()));
    }
    return model::RunStatus::completed;
}

} // namespace corticle::sensitivity
