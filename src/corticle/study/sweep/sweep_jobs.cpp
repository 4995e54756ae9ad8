// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_jobs.hpp"

#include "corticle/base/child_process.hpp"
#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/record/folder_lock.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/sweep/command_process.hpp"
#include "corticle/study/sweep/sweep_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <numeric>

#include <unistd.h>

namespace corticle::sweep
{

namespace
{

namespace fs = std::filesystem;

constexpr int interrupted_status = 130;
constexpr useconds_t pause_us = 20000; // between looks at the processes

// For estimates of cost.
constexpr double volume_of_a_file = 8000.0; // [mm³]
constexpr double elements_per_node = 5.0;
constexpr double steps_per_crossing = 2.8; // over the particles along the radius and cfl

bool is_locked(const fs::path& folder)
{
    return !record::FolderLock::try_lock(folder);
}

/// The last line of what a command wrote, without its prefix.
std::string last_line(std::string text)
{
    text.erase(text.find_last_not_of("\n\r ") + 1);
    text.erase(0, text.rfind('\n') + 1);
    constexpr std::string_view prefix = "corticle: error: ";
    return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

/// How a run stands after its process ended.
RunState state_after(const fs::path& folder, const ProcessEnd& end)
{
    RunState state = read_state(folder);
    const bool is_told = end.signal == 0 && ((end.status == 0 && state.status == "completed") ||
                                             (end.status == 3 && state.status == "failed") ||
                                             (end.status == interrupted_status && state.status == "interrupted"));
    if (is_told)
    {
        return state;
    }
    state.status = end.status == interrupted_status ? "interrupted" : "failed";
    const std::string said = last_line(end.output);
    state.reason = end.signal != 0 ? fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal))
                   : said.empty()  ? fmt::format("exit status {} without a message", end.status)
                                   : said;
    return state;
}

/// The processes of a sweep.
class Crew
{
  public:
    Crew(std::span<const SweepJob> jobs, const JobOptions& options,
         const std::function<void(std::size_t, const RunState&)>& ended)
        : jobs_(jobs), options_(options), ended_(ended), cores_(thread_count()),
          progress_(jobs, options.done, options.quiet)
    {
        waiting_.resize(jobs.size());
        std::iota(waiting_.begin(), waiting_.end(), std::size_t{0});
        std::ranges::stable_sort(waiting_, std::greater<>{}, [&](std::size_t i) { return jobs[i].cost; });
        const int by_threads = options.threads_per_run > 0 ? std::max(1, cores_ / options.threads_per_run) : cores_;
        slots_ = static_cast<std::size_t>(options.jobs > 0 ? options.jobs : by_threads);
    }

    bool is_done() const { return waiting_.empty() && running_.empty(); }
    void look();
    void start_some();
    void end_all();

  private:
    struct Running
    {
        std::size_t job;
        int threads;
        CommandProcess process;
    };

    void finish(std::size_t job, const RunState& state);
    void start(std::size_t job, int threads);
    int threads_for_next() const;

    std::span<const SweepJob> jobs_;
    const JobOptions& options_;
    const std::function<void(std::size_t, const RunState&)>& ended_;
    int cores_;
    std::size_t slots_;
    std::vector<std::size_t> waiting_;
    std::vector<Running> running_;
    SweepProgress progress_;
    bool is_ending_ = false;
};

void Crew::finish(std::size_t job, const RunState& state)
{
    progress_.finish(job, state);
    ended_(job, state);
}

/// Notes the processes that have ended.
void Crew::look()
{
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < running_.size();)
    {
        const std::size_t job = running_[i].job;
        const std::optional<ProcessEnd> end = running_[i].process.poll();
        if (!end)
        {
            active.push_back(job);
            ++i;
            continue;
        }
        running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
        // Before its first step.
        const bool is_ended_by_us = is_ending_ && (end->signal == SIGTERM || end->status == interrupted_status);
        finish(job, is_ended_by_us ? read_state(jobs_[job].folder) : state_after(jobs_[job].folder, *end));
    }
    progress_.update(active);
}

/// Free cores over the runs that are about to share them.
int Crew::threads_for_next() const
{
    if (options_.threads_per_run > 0)
    {
        return options_.threads_per_run;
    }
    int free = cores_;
    for (const Running& one : running_)
    {
        free -= one.threads;
    }
    const auto sharing = static_cast<int>(std::min(waiting_.size(), slots_ - running_.size()));
    return std::max(1, free / std::max(1, sharing));
}

void Crew::start(std::size_t job, int threads)
{
    const SweepJob& one = jobs_[job];
    try
    {
        std::vector<std::string> words = run_words(options_.command, one);
        words.insert(words.end(), {"--threads", std::to_string(threads)});
        running_.push_back({job, threads, CommandProcess(words)});
    }
    catch (const RunError& error)
    {
        RunState state;
        state.status = "failed";
        state.reason = error.what();
        finish(job, state);
    }
}

/// Starts runs while there is room; one whose folder another process holds waits, and counts as made if that process
/// finished it.
void Crew::start_some()
{
    for (std::size_t i = 0; i < waiting_.size() && running_.size() < slots_;)
    {
        const std::size_t job = waiting_[i];
        if (is_locked(jobs_[job].folder))
        {
            ++i;
            continue;
        }
        const int threads = threads_for_next();
        waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
        const RunState state = read_state(jobs_[job].folder);
        if (state.status == "completed" || (state.status == "failed" && !jobs_[job].retry))
        {
            finish(job, state);
        }
        else
        {
            start(job, threads);
        }
    }
}

void Crew::end_all()
{
    for (const Running& one : running_)
    {
        one.process.terminate();
    }
    waiting_.clear();
    is_ending_ = true;
}

} // namespace

std::vector<std::string> run_words(const std::string& command, const SweepJob& job)
{
    return {command, "run", job.case_file.string(), "--out", job.folder.string(), "--resume", "--quiet"};
}

double relative_cost(const config::Options& options)
{
    const prepare::GeometryOptions& geometry = options.geometry;
    const dynamics::DynamicsOptions& dynamics = options.dynamics;
    const double volume = config::shape_volume(geometry) > 0.0 ? config::shape_volume(geometry) : volume_of_a_file;
    const double particles = geometry.particles    ? static_cast<double>(*geometry.particles)
                             : options.elements    ? static_cast<double>(*options.elements) / elements_per_node
                             : geometry.spacing_mm ? volume / std::pow(*geometry.spacing_mm, 3.0)
                                                   : static_cast<double>(prepare::default_particles);
    const double spacing = std::cbrt(volume / particles);
    const double neighbors = std::pow(tlsph::support_mm(options.tlsph, spacing) / spacing, 3.0);
    const double span = std::max(options.time.end - options.time.start, 1e-6);
    const double steps = dynamics.time_step > 0.0 ? span / dynamics.time_step
                                                  : span * dynamics::quickened_steps(dynamics) * steps_per_crossing *
                                                        dynamics.loading_time * std::cbrt(particles) / dynamics.cfl;
    const double stages = dynamics.integrator == dynamics::Integrator::rk4 ? 4.0 : 1.0;
    return particles * neighbors * steps * stages;
}

bool make_runs(std::span<const SweepJob> jobs, const JobOptions& options,
               const std::function<void(std::size_t, const RunState&)>& ended)
{
    const WaitableChildren waitable;
    Crew crew(jobs, options, ended);
    bool is_interrupted = false;
    while (!crew.is_done())
    {
        crew.look();
        if (study::InterruptionGuard::requested() && !is_interrupted)
        {
            is_interrupted = true;
            crew.end_all();
        }
        if (!is_interrupted)
        {
            crew.start_some();
        }
        usleep(pause_us);
    }
    return !is_interrupted;
}

} // namespace corticle::sweep
