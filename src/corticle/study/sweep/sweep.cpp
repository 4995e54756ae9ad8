// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/terminal.hpp"
#include "corticle/base/version.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/sweep/sweep_jobs.hpp"
#include "corticle/study/sweep/sweep_submission.hpp"
#include "corticle/study/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace corticle::sweep
{

namespace
{

namespace fs = std::filesystem;

/// A run folder of its own may not become a sweep.
void require_no_run(const fs::path& out)
{
    if (record::is_run_folder(out))
    {
        throw InputError(fmt::format("--out {}: holds a run; expected another folder for the sweep", out.string()));
    }
}

/// Where the case of a run is written, relative to the folder of the sweep.
std::string case_file_of(const fs::path& run_folder)
{
    return "cases/" + run_folder.filename().string() + ".toml";
}

/// What is written into the folder of the sweep itself.
std::vector<std::string> written_files(const SweepTable& table, bool with_pictures)
{
    std::vector<std::string> files{"sweep.csv", "sweep.json", "sweep.md"};
    for (const SweepRow& row : table.rows)
    {
        files.push_back(case_file_of(row.folder));
    }
    if (with_pictures)
    {
        const std::vector<std::string> pictures = sweep_pictures(table);
        files.insert(files.end(), pictures.begin(), pictures.end());
    }
    return files;
}

SweepTable plan_sweep(const SweepRequest& request)
{
    SweepTable table;
    table.sweep = read_sweep(request.file);
    change_settings(table.sweep, request.overrides);
    table.runs = sweep_runs(table.sweep);
    table.out = fs::absolute(request.out).lexically_normal();
    require_known_measures(table.sweep);
    given_references(table.sweep, table.runs); // refuses a reference to no run before anything is made
    return table;
}

/// How the runs stand before any is made.
void look_at_folders(SweepTable& table, const RunFolders& folders)
{
    for (std::size_t i = 0; i < table.runs.size(); ++i)
    {
        SweepRow row;
        row.run = i;
        row.folder = folders.of_run[i].lexically_relative(table.out);
        row.state = read_state(folders.of_run[i]);
        const std::string failure = task_failure(table.out, folders.of_run[i].filename().string());
        if (row.state.status == "pending" && !failure.empty())
        {
            row.state.status = "failed";
            row.state.reason = failure;
        }
        row.is_kept = row.state.is_finished();
        table.rows.push_back(std::move(row));
    }
}

/// What will be done, in a line.
std::string outline(const SweepTable& table, const std::vector<bool>& is_chosen, std::size_t unused)
{
    const auto count = [&](auto&& belongs)
    { return std::ranges::count_if(table.rows, [&](const SweepRow& row) { return belongs(row); }); };
    const auto kept = count([](const SweepRow& row) { return row.is_kept; });
    const auto begun = count([](const SweepRow& row) { return row.state.status == "interrupted"; });
    const auto left_out = count([&](const SweepRow& row) { return !row.is_kept && !is_chosen[row.run]; });
    const auto foreign =
        count([](const SweepRow& row) { return row.is_kept && row.state.version != program_version(); });
    std::string text = fmt::format("{} runs: {} kept, finished before", table.rows.size(), kept);
    text += foreign > 0 ? fmt::format(" ({} of them by another version than {})", foreign, program_version()) : "";
    text += begun > 0 ? fmt::format("; {} interrupted", begun) : "";
    text += left_out > 0 ? fmt::format("; {} left out by --only", left_out) : "";
    text += unused > 0 ? fmt::format("; {} other runs in {} are not part of this sweep and are left alone", unused,
                                     (table.out / "runs").string())
                       : "";
    return text + "\n";
}

/// Says which growth times of measures ("KEY@T") runs do not reach.
void warn_of_unreached_times(const SweepTable& table)
{
    const auto warn = [&](const std::string& what, double t)
    {
        const auto beyond = std::ranges::count_if(table.runs,
                                                  [&](const SweepRun& run) {
                                                      return t < run.options.time.start - model::same_output_time ||
                                                             t > run.options.time.end + model::same_output_time;
                                                  });
        if (beyond > 0)
        {
            fmt::print(stderr, "corticle: warning: {}: t = {:g} lies outside {} of {} runs, whose cells stay empty\n",
                       what, t, beyond, table.runs.size());
        }
    };
    for (const SweepMeasure& measure : table.sweep.measures)
    {
        if (measure.t)
        {
            warn(fmt::format("measures ({}) {}", measure.where, measure.text), *measure.t);
        }
    }
}

/// Options of which one leaves nothing for the other to do.
void require_sensible(const SweepRequest& request)
{
    const std::array<std::pair<bool, const char*>, 4> ways{{{request.engine != Engine::local, "--engine"},
                                                            {request.cases_only, "--cases-only"},
                                                            {request.gather, "--gather"},
                                                            {request.list, "--list"}}};
    const char* first = nullptr;
    for (const auto& [is_asked, option] : ways)
    {
        if (is_asked && first != nullptr)
        {
            throw InputError(fmt::format("{} and {} are both given; expected one of them", first, option));
        }
        first = is_asked ? option : first;
    }
    if (request.jobs > 0 && request.engine == Engine::commands)
    {
        throw InputError("--jobs is given, but --engine commands makes no runs; expected it of what runs the commands");
    }
}

/// Writes the cases to be run and returns the runs to be made; runs that share a folder are made once.
std::vector<SweepJob> prepare_jobs(const SweepTable& table, const SweepRequest& request,
                                   const std::vector<bool>& is_chosen)
{
    std::vector<SweepJob> jobs;
    std::set<fs::path> folders;
    for (const SweepRow& row : table.rows)
    {
        const SweepRun& run = table.runs[row.run];
        const fs::path case_file = table.out / case_file_of(row.folder);
        const bool is_to_do = !row.is_kept || (request.retry && row.state.status == "failed");
        if (!folders.insert(row.folder).second)
        {
            continue;
        }
        formats::write_text_atomically(case_file, run.case_text);
        if (is_to_do && is_chosen[row.run] && !request.cases_only && !request.gather)
        {
            jobs.push_back({case_file, table.out / row.folder, relative_cost(run.options), run.options.time.start,
                            run.options.time.end, request.retry});
        }
    }
    return jobs;
}

void write_tables(const SweepTable& table, const study::Pictures& pictures)
{
    formats::write_text_atomically(table.out / "sweep.csv", sweep_csv(table));
    formats::write_text_atomically(table.out / "sweep.json", sweep_json(table, pictures));
    formats::write_text_atomically(table.out / "sweep.md", sweep_markdown(table, pictures));
}

void print_end(const SweepTable& table, const study::Pictures& pictures)
{
    const auto count = [&](const char* status)
    { return std::ranges::count_if(table.rows, [&](const SweepRow& row) { return row.state.status == status; }); };
    fmt::print("{} completed, {} failed, {} not made; wrote {}\n", count("completed"), count("failed"),
               count("pending") + count("interrupted"), (table.out / "sweep.md").string());
    if (!pictures.reason.empty())
    {
        fmt::print(stderr, "corticle: warning: no pictures: {}\n", pictures.reason);
    }
}

/// The program by a name that other processes can use.
std::string program_path(const SweepRequest& request)
{
    return fs::canonical(request.command).string();
}

/// The command that gathers this sweep.
std::vector<std::string> gathering_words(const SweepTable& table, const SweepRequest& request)
{
    std::vector<std::string> words{program_path(request), "sweep",   fs::absolute(request.file).string(), "--out",
                                   table.out.string(),    "--gather"};
    for (const std::string& text : request.overrides)
    {
        words.insert(words.end(), {"--set", text});
    }
    return words;
}

void submit_jobs(const SweepTable& table, std::span<const SweepJob> jobs, const SweepRequest& request)
{
    Submission submission{table.out,    request.file.stem().string(),   table.sweep.engine, program_path(request),
                          request.jobs, gathering_words(table, request)};
    const auto is_odd = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; };
    std::ranges::replace_if(submission.name, is_odd, '_');
    submission.engine.cpus = request.threads_per_run > 0 ? request.threads_per_run : submission.engine.cpus;
    const SubmittedJobs submitted = submit(submission, {jobs.begin(), jobs.end()});
    if (request.quiet)
    {
        return;
    }
    const std::string queued =
        submitted.queued > 0 ? fmt::format("{} runs are in the queue since an earlier call; ", submitted.queued) : "";
    show(stdout, submitted.runs == 0
                     ? queued + "nothing else to submit\n"
                     : fmt::format("{}submitted {} runs as array job {}, and job {} that gathers them; the same "
                                   "command again submits what is unfinished then\n",
                                   queued, submitted.runs, submitted.array, submitted.gathering));
}

/// Prints or submits the runs; false where they are to be made here.
bool hand_over(const SweepTable& table, std::span<const SweepJob> jobs, const SweepRequest& request)
{
    if (request.engine == Engine::slurm)
    {
        submit_jobs(table, jobs, request);
    }
    else if (request.engine == Engine::commands)
    {
        for (const SweepJob& job : jobs)
        {
            std::vector<std::string> words = run_words(program_path(request), job);
            if (request.threads_per_run > 0)
            {
                words.insert(words.end(), {"--threads", std::to_string(request.threads_per_run)});
            }
            fmt::print("{}\n", shell_line(words));
        }
    }
    return request.engine != Engine::local;
}

/// Makes the runs; the tables are written anew after each. False when interrupted.
bool make_all(SweepTable& table, std::span<const SweepJob> jobs, const SweepRequest& request)
{
    const auto ended = [&](std::size_t job, const RunState& state)
    {
        for (SweepRow& row : table.rows)
        {
            if (table.out / row.folder == jobs[job].folder)
            {
                row.state = state;
                read_measures(table, row);
            }
        }
        write_tables(table, {});
    };
    const auto done = static_cast<std::size_t>(std::ranges::count_if(table.rows, &SweepRow::is_kept));
    return make_runs(jobs, {request.command, request.jobs, request.threads_per_run, done, request.quiet}, ended);
}

/// Looks at what is there and writes cases and tables; the runs that are to be made.
std::vector<SweepJob> begin(SweepTable& table, const SweepRequest& request, const std::vector<bool>& is_chosen,
                            record::ResultFolder& folder)
{
    const RunFolders folders = assign_folders(table.out, table.runs);
    look_at_folders(table, folders);
    folder.require_free(written_files(table, table.sweep.has_pictures));
    folder.make();
    folder.remove_leftovers();
    folder.claim(written_files(table, false));
    for (SweepRow& row : table.rows)
    {
        read_measures(table, row);
    }
    if (!request.quiet)
    {
        show(request.engine == Engine::commands ? stderr : stdout, outline(table, is_chosen, folders.unused));
    }
    std::vector<SweepJob> jobs = prepare_jobs(table, request, is_chosen);
    write_tables(table, {});
    return jobs;
}

/// Makes the runs that are missing, or hands them over; how that ended, unless all are to be gathered now.
std::optional<model::RunStatus> make_missing(SweepTable& table, const SweepRequest& request,
                                             const std::vector<bool>& is_chosen, record::ResultFolder& folder)
{
    const study::InterruptionGuard guard;
    const std::vector<SweepJob> jobs = begin(table, request, is_chosen, folder);
    if (request.cases_only || (!jobs.empty() && hand_over(table, jobs, request)))
    {
        return model::RunStatus::completed;
    }
    if (!make_all(table, jobs, request))
    {
        write_tables(table, {});
        return model::RunStatus::interrupted;
    }
    return std::nullopt;
}

void finish(SweepTable& table, const SweepRequest& request, record::ResultFolder& folder)
{
    compare_to_references(table);
    const study::Pictures pictures = draw_sweep(table, folder);
    write_tables(table, pictures);
    if (!request.quiet && request.engine != Engine::commands)
    {
        print_end(table, pictures);
    }
}

void print_standing(SweepTable& table, const std::vector<bool>& is_chosen)
{
    const RunFolders folders = assign_folders(table.out, table.runs);
    look_at_folders(table, folders);
    fmt::print("{}", outline(table, is_chosen, folders.unused));
    for (const SweepRow& row : table.rows)
    {
        fmt::print("{:>4}  {:<40} {:<12} {}\n", row.run + 1, table.runs[row.run].name, row.state.status,
                   row.state.reason);
    }
}

} // namespace

model::RunStatus sweep(const SweepRequest& request)
{
    require_sensible(request);
    SweepTable table = plan_sweep(request);
    const std::vector<bool> is_chosen = chosen_runs(table.sweep, table.runs, request.only);
    require_no_run(table.out);
    if (!request.quiet)
    {
        warn_of_unreached_times(table);
    }
    if (request.list)
    {
        print_standing(table, is_chosen);
        return model::RunStatus::completed;
    }
    record::ResultFolder folder(table.out, "sweep");
    if (const auto ended = make_missing(table, request, is_chosen, folder))
    {
        return *ended;
    }
    finish(table, request, folder);
    return model::RunStatus::completed;
}

} // namespace corticle::sweep
