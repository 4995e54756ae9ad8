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
#include "corticle/study/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
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
        if (is_to_do && is_chosen[row.run] && !request.cases_only)
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

/// Looks at what is there, and makes what is not. False when interrupted.
bool make_missing(SweepTable& table, const SweepRequest& request, const std::vector<bool>& is_chosen,
                  record::ResultFolder& folder)
{
    const study::InterruptionGuard guard;
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
        show(stdout, outline(table, is_chosen, folders.unused));
    }
    const std::vector<SweepJob> jobs = prepare_jobs(table, request, is_chosen);
    write_tables(table, {});
    const bool is_made = make_all(table, jobs, request);
    write_tables(table, {});
    return is_made;
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
    if (!make_missing(table, request, is_chosen, folder))
    {
        return model::RunStatus::interrupted;
    }
    if (request.cases_only)
    {
        return model::RunStatus::completed;
    }
    compare_to_references(table);
    const study::Pictures pictures = draw_sweep(table, folder);
    write_tables(table, pictures);
    if (!request.quiet)
    {
        print_end(table, pictures);
    }
    return model::RunStatus::completed;
}

} // namespace corticle::sweep
