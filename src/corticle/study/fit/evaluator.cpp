// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/evaluator.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/sweep/sweep_jobs.hpp"
#include "corticle/study/sweep/sweep_runs.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace corticle::fit
{

namespace
{

namespace fs = std::filesystem;

constexpr int most_tries = 2; // of a run that something else than itself ends

/// What happened to runs that did not say it themselves: {"0123...": "reason"}.
std::map<std::string, std::string> read_failures(const fs::path& file)
{
    std::ifstream stream(file);
    const auto json = nlohmann::json::parse(stream, nullptr, false);
    std::map<std::string, std::string> failures;
    if (json.is_object())
    {
        for (const auto& [key, reason] : json.items())
        {
            failures[key] = reason.is_string() ? reason.get<std::string>() : "";
        }
    }
    return failures;
}

bool leaves_trace(const sweep::RunState& state)
{
    return state.is_finished();
}

} // namespace

/// A run on its way.
struct Evaluator::Planned
{
    Evaluation evaluation;
    std::string key;
    sweep::SweepJob job;
};

Evaluator::Evaluator(fs::path base, std::vector<std::string> settings, const ParameterSpace& space,
                     std::vector<Quantity> quantities, RunMaking making)
    : base_(std::move(base)), base_text_(config::read_case_text(base_)), settings_(std::move(settings)), space_(space),
      quantities_(std::move(quantities)), making_(std::move(making)),
      failures_(read_failures(making_.out / "failures.json"))
{
}

config::Options Evaluator::options_at(std::span<const double> u, std::span<const std::string> more) const
{
    std::vector<std::string> overrides = settings_;
    overrides.insert(overrides.end(), more.begin(), more.end());
    const std::vector<std::string> chosen = space_.overrides(u);
    overrides.insert(overrides.end(), chosen.begin(), chosen.end());
    config::Options options = config::parse_case(base_text_, base_.string(), overrides, base_.parent_path());
    config::identify_inputs(options);
    return options;
}

Evaluator::Planned Evaluator::plan(const Point& u, const std::string& stage, std::span<const std::string> more) const
{
    Planned planned;
    planned.evaluation = {stage, u, space_.values(u), "", "", {}};
    try
    {
        const config::Options options = options_at(u, more);
        planned.key = sweep::run_key(options);
        planned.evaluation.folder = "runs/" + planned.key;
        planned.job = {making_.out / "cases" / (planned.key + ".toml"),
                       making_.runs / planned.key,
                       sweep::relative_cost(options),
                       options.time.start,
                       options.time.end,
                       false};
        formats::write_text_atomically(planned.job.case_file, config::to_toml(options));
    }
    catch (const InputError& error)
    {
        planned.evaluation.failure = error.what();
    }
    return planned;
}

void Evaluator::note_failure(const std::string& key, const std::string& reason)
{
    failures_[key] = reason;
    formats::write_text_atomically(making_.out / "failures.json", nlohmann::json(failures_).dump(2) + "\n");
}

/// Makes those runs that are not finished, each once. One that is ended from outside is tried again; how it ended then
/// is noted, so that it is not tried for ever and the study goes the same way when it is made again.
void Evaluator::make(std::span<Planned> planned)
{
    for (int tries = 1; tries <= most_tries; ++tries)
    {
        std::map<std::string, sweep::SweepJob> missing;
        for (const Planned& one : planned)
        {
            if (!one.key.empty() && !failures_.contains(one.key) && !leaves_trace(sweep::read_state(one.job.folder)))
            {
                missing.emplace(one.key, one.job);
            }
        }
        std::vector<std::string> keys;
        std::vector<sweep::SweepJob> jobs;
        for (const auto& [key, job] : missing)
        {
            keys.push_back(key);
            jobs.push_back(job);
        }
        const auto ended = [&](std::size_t job, const sweep::RunState& state)
        {
            ++made_;
            const bool is_silent = state.status == "failed" && !leaves_trace(sweep::read_state(jobs[job].folder));
            const bool is_ended_from_outside = state.reason.starts_with("ended by signal");
            if (is_silent && (!is_ended_from_outside || tries == most_tries))
            {
                note_failure(keys[job], state.reason);
            }
        };
        const bool is_quiet = making_.quiet || planned.size() == 1;
        if (!jobs.empty() &&
            !sweep::make_runs(jobs, {making_.command, making_.jobs, making_.threads_per_run, 0, is_quiet}, ended))
        {
            throw Interrupted();
        }
    }
}

void Evaluator::collect(Planned& planned) const
{
    Evaluation& evaluation = planned.evaluation;
    if (planned.key.empty())
    {
        return;
    }
    const sweep::RunState state = sweep::read_state(planned.job.folder);
    const auto noted = failures_.find(planned.key);
    if (state.status != "completed")
    {
        evaluation.failure = noted != failures_.end() ? noted->second
                             : state.reason.empty()   ? "the run did not end"
                                                      : state.reason;
        return;
    }
    try
    {
        evaluation.predicted = predicted_by(planned.job.folder, quantities_);
    }
    catch (const InputError& error)
    {
        evaluation.failure = error.what();
        return;
    }
    for (std::size_t q = 0; q < quantities_.size(); ++q)
    {
        if (!std::isfinite(evaluation.predicted[q]) && evaluation.failure.empty())
        {
            evaluation.failure = fmt::format("the run gives no {}", quantities_[q].name());
        }
    }
}

std::vector<Evaluation> Evaluator::evaluate(std::span<const Point> points, const std::string& stage,
                                            std::span<const std::string> more)
{
    const study::InterruptionGuard guard;
    std::vector<Planned> planned;
    for (const Point& u : points)
    {
        planned.push_back(plan(u, stage, more));
    }
    make(planned);
    std::vector<Evaluation> evaluations;
    for (Planned& one : planned)
    {
        collect(one);
        evaluations.push_back(std::move(one.evaluation));
    }
    return evaluations;
}

} // namespace corticle::fit
