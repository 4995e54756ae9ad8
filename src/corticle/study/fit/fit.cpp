// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/fit.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/terminal.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/fit/evaluations_table.hpp"
#include "corticle/study/fit/fit_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::fit
{

namespace
{

namespace fs = std::filesystem;

constexpr double penalty_factor = 2.0;      // of failed runs, over the worst misfit so far
constexpr double penalty_without_run = 1e6; // while none has succeeded
constexpr std::size_t fewest_runs = 4;      // to learn an emulator from

/// A fit on its way.
class Fitting
{
  public:
    Fitting(const FitFile& fit, const FitRequest& request, record::ResultFolder& folder)
        : fit_(fit), request_(request), folder_(folder),
          evaluator_(fit.study.base, fit.study.settings, fit_.space, fit.quantities(),
                     {folder.path(), request.runs.empty() ? folder.path() / "runs" : fs::absolute(request.runs),
                      request.command, request.jobs, request.threads_per_run, request.quiet})
    {
    }

    FitResult find();

  private:
    void add(std::span<const Point> points, const std::string& stage, std::span<const std::string> more = {});
    void search();
    void design();
    Emulator emulator() const;
    std::vector<Point> likely_points(const Knowledge& knowledge, int count, std::uint64_t seed) const;
    std::optional<Knowledge> refine();
    void correct(Emulator& emulator);
    std::vector<Point> starts() const;
    double penalty() const;
    void say(const Evaluation& evaluation) const;

    const FitFile& fit_;
    const FitRequest& request_;
    record::ResultFolder& folder_;
    Evaluator evaluator_;
    std::vector<Evaluation> evaluations_;
};

void Fitting::say(const Evaluation& evaluation) const
{
    if (request_.quiet)
    {
        return;
    }
    std::string text = fmt::format("{:>4}  {:<10}", evaluations_.size(), evaluation.stage);
    for (std::size_t k = 0; k < fit_.space.size(); ++k)
    {
        text += fmt::format("  {} {:.5g}", fit_.space.parameters[k].name(), evaluation.values[k]);
    }
    text += evaluation.failure.empty() ? fmt::format("  misfit {:.4g}\n", misfit(fit_, evaluation))
                                       : "  failed: " + evaluation.failure + "\n";
    show(stdout, text);
}

/// Makes runs, side by side in bundles, so that the table follows them.
void Fitting::add(std::span<const Point> points, const std::string& stage, std::span<const std::string> more)
{
    for (Evaluation& one : evaluator_.evaluate(points, stage, more))
    {
        evaluations_.push_back(std::move(one));
        say(evaluations_.back());
    }
    std::vector<double> misfits;
    for (const Evaluation& one : evaluations_)
    {
        misfits.push_back(misfit(fit_, one));
    }
    formats::write_text_atomically(folder_.path() / "evaluations.csv",
                                   evaluations_table(fit_.space, fit_.quantities(), evaluations_, misfits));
}

/// What a failed run counts as: worse than all so far, but not so much that a method which models the misfit goes
/// astray.
double Fitting::penalty() const
{
    double worst = 0.0;
    for (const Evaluation& one : evaluations_)
    {
        worst = one.failure.empty() ? std::max(worst, misfit(fit_, one)) : worst;
    }
    return worst > 0.0 ? penalty_factor * worst : penalty_without_run;
}

void Fitting::search()
{
    const Objective objective = [&](std::span<const double> u)
    {
        const std::vector<Point> point{Point(u.begin(), u.end())};
        add(point, "search");
        return evaluations_.back().failure.empty() ? misfit(fit_, evaluations_.back()) : penalty();
    };
    minimize(objective, fit_.space.start(), *fit_.search);
}

/// A latin hypercube, over the cube or about the best point so far.
void Fitting::design()
{
    const auto count = static_cast<std::size_t>(fit_.surrogate.points);
    std::vector<Point> points = latin_hypercube(count, fit_.space.size(), fit_.study.seed);
    const std::optional<std::size_t> best = best_evaluation(fit_, evaluations_);
    const Point centre = best ? evaluations_[*best].u : fit_.space.start();
    const double width = fit_.surrogate.width;
    for (Point& point : points)
    {
        for (std::size_t k = 0; k < point.size(); ++k)
        {
            const double low = std::clamp(centre[k] - 0.5 * width, 0.0, 1.0 - width);
            point[k] = low + width * point[k];
        }
    }
    add(points, "design");
}

Emulator Fitting::emulator() const
{
    std::vector<Evaluation> cheap;
    std::ranges::copy_if(evaluations_, std::back_inserter(cheap),
                         [](const Evaluation& one) { return one.stage != "dear" && one.failure.empty(); });
    if (cheap.size() < std::max(fewest_runs, fit_.space.size() + 2))
    {
        const auto failed =
            std::ranges::find_if(evaluations_, [](const Evaluation& one) { return !one.failure.empty(); });
        throw RunError(fmt::format(
            "{} of {} runs gave what the targets need, too few to learn from; {}", cheap.size(), evaluations_.size(),
            failed == evaluations_.end() ? "expected more points" : "one said: " + failed->failure));
    }
    const std::vector<Quantity> quantities = fit_.quantities();
    return {cheap, quantities};
}

std::vector<Point> Fitting::starts() const
{
    const std::optional<std::size_t> best = best_evaluation(fit_, evaluations_);
    return {best ? evaluations_[*best].u : fit_.space.start()};
}

/// The most likely point, and draws.
std::vector<Point> Fitting::likely_points(const Knowledge& knowledge, int count, std::uint64_t seed) const
{
    std::vector<Point> points{knowledge.mode};
    Random random(seed);
    while (std::ssize(points) < count)
    {
        points.push_back(knowledge.draws.points[random.index(knowledge.draws.points.size())]);
    }
    return points;
}

/// Rounds of runs near the answer, until the emulator's errors hardly count in it. @return what is known then; nothing
/// where the rounds end before
std::optional<Knowledge> Fitting::refine()
{
    for (int round = 1; round <= fit_.surrogate.refinements; ++round)
    {
        Knowledge knowledge = learn(fit_, emulator(), starts());
        if (knowledge.of_emulator.maxCoeff() <= fit_.surrogate.share)
        {
            return knowledge;
        }
        add(likely_points(knowledge, fit_.surrogate.runs_a_round, fit_.study.seed + static_cast<std::uint64_t>(round)),
            "refinement");
    }
    return std::nullopt;
}

/// Dear runs: at the most likely point, at draws, and last at the most likely point once all others have corrected it.
void Fitting::correct(Emulator& emulator)
{
    for (int run = 0; run < fit_.fidelity.runs; ++run)
    {
        const Knowledge knowledge = learn(fit_, emulator, starts());
        const bool is_mode = run == 0 || run + 1 == fit_.fidelity.runs;
        const std::vector<Point> points =
            likely_points(knowledge, 2, fit_.study.seed + 1000 + static_cast<std::uint64_t>(run));
        add(std::span(points).subspan(is_mode ? 0 : 1, 1), "dear", fit_.fidelity.settings);
        std::vector<Evaluation> dear;
        std::ranges::copy_if(evaluations_, std::back_inserter(dear),
                             [](const Evaluation& one) { return one.stage == "dear"; });
        emulator.correct(dear);
    }
}

FitResult Fitting::find()
{
    FitResult result;
    if (fit_.search)
    {
        search();
    }
    if (fit_.surrogate.points > 0)
    {
        design();
        result.knowledge = refine();
        if (!fit_.fidelity.settings.empty())
        {
            Emulator last = result.knowledge ? std::move(result.knowledge->emulator) : emulator();
            correct(last);
            result.knowledge = learn(fit_, std::move(last), starts());
        }
        else if (!result.knowledge)
        {
            result.knowledge = learn(fit_, emulator(), starts());
        }
    }
    const std::optional<std::size_t> best = best_evaluation(fit_, evaluations_);
    if (!best)
    {
        throw RunError(
            fmt::format("all {} runs failed; the first: {}", evaluations_.size(), evaluations_.front().failure));
    }
    result.best = *best;
    result.has_best = true;
    result.evaluations = std::move(evaluations_);
    return result;
}

void write(const FitFile& fit, const FitResult& result, record::ResultFolder& folder)
{
    const auto plots = fit_plots(fit, result);
    std::vector<std::string> files;
    for (const auto& [name, text] : plots)
    {
        files.push_back(name);
    }
    folder.claim(files);
    for (const auto& [name, text] : plots)
    {
        formats::write_text_atomically(folder.path() / name, text);
    }
    const Evaluation& best = result.evaluations[result.best];
    const fs::path cases = folder.path() / "cases" / (fs::path(best.folder).filename().string() + ".toml");
    formats::write_text_atomically(folder.path() / "best.toml", config::to_toml(config::read_case(cases, {})));
    formats::write_text_atomically(folder.path() / "fit.json", fit_json(fit, result));
    formats::write_text_atomically(folder.path() / "fit.md", fit_markdown(fit, result));
}

} // namespace

model::RunStatus fit(const FitRequest& request)
{
    const FitFile fit = read_fit(request.file, request.overrides);
    const fs::path out = fs::absolute(request.out).lexically_normal();
    if (record::is_run_folder(out))
    {
        throw InputError(fmt::format("--out {}: holds a run; expected another folder for the fit", out.string()));
    }
    record::ResultFolder folder(out, "fit");
    const std::vector<std::string> files{"best.toml", "evaluations.csv", "failures.json", "fit.json", "fit.md"};
    folder.require_free(files);
    folder.make();
    folder.remove_leftovers();
    folder.claim(files);
    fs::create_directories(out / "cases");
    try
    {
        const FitResult result = Fitting(fit, request, folder).find();
        write(fit, result, folder);
    }
    catch (const Interrupted&)
    {
        return model::RunStatus::interrupted;
    }
    if (!request.quiet)
    {
        show(stdout, fmt::format("wrote {}\n", (out / "fit.md").string()));
    }
    return model::RunStatus::completed;
}

} // namespace corticle::fit
