// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_submission.hpp"

#include "corticle/base/child_process.hpp"
#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <unistd.h>

namespace corticle::sweep
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t most_tasks = 1000; // of one array: Slurm's default MaxArraySize is 1001
constexpr const char* error_prefix = "corticle: error: ";
constexpr int most_restarts = 100; // of a task by itself

std::string shell_word(const std::string& word)
{
    const auto is_plain = [](char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("-_./:=,+").find(c) != std::string::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain))
    {
        return word;
    }
    std::string quoted = "'";
    for (const char c : word)
    {
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return quoted + "'";
}

/// A program of Slurm on the PATH.
std::string find_program(const std::string& name)
{
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
    {
        const fs::path file = fs::path(folder) / name;
        if (!folder.empty() && access(file.c_str(), X_OK) == 0)
        {
            return file.string();
        }
    }
    return "";
}

std::string first_line(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

/// Submits a script; the number of its job.
std::string sbatch(const fs::path& script, const std::string& after)
{
    const std::string program = find_program("sbatch");
    if (program.empty())
    {
        throw RunError("--engine slurm: no sbatch on the PATH; expected a machine that submits to Slurm");
    }
    std::vector<std::string> words{program, "--parsable"};
    if (!after.empty())
    {
        words.push_back("--dependency=afterany:" + after);
    }
    words.push_back(script.string());
    const ProcessEnd end = run_program(words, "");
    const std::string line = first_line(end.output);
    const std::string number = line.substr(0, line.find(';')); // NUMBER;CLUSTER
    if (end.status != 0 || end.signal != 0 || number.empty())
    {
        throw RunError(fmt::format("sbatch {} failed: {}", script.string(), first_line(end.errors)));
    }
    return number;
}

/// Tasks of an array job that wait or run; none where Slurm no longer knows it.
std::set<std::size_t> queued_tasks(const std::string& array)
{
    const std::string program = find_program("squeue");
    std::set<std::size_t> tasks;
    if (program.empty())
    {
        return tasks;
    }
    const ProcessEnd end = run_program({program, "--noheader", "--array", "--jobs=" + array, "--format=%K"}, "");
    std::istringstream numbers(end.status == 0 ? end.output : "");
    for (std::size_t task = 0; numbers >> task;)
    {
        tasks.insert(task);
    }
    return tasks;
}

std::vector<std::string> lines_of(const fs::path& file)
{
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// Files of one submission: OUT/slurm/1.sh, 1.runs, 1.job ...
struct Files
{
    fs::path folder;
    int number = 1;

    fs::path with(const char* ending) const { return folder / (std::to_string(number) + ending); }
};

std::size_t task_count(std::size_t runs)
{
    return std::min(runs, most_tasks);
}

/// Names of runs that tasks of earlier submissions are still to make.
std::set<std::string> queued_runs(const fs::path& folder)
{
    std::set<std::string> names;
    for (Files files{folder}; fs::exists(files.with(".sh")); ++files.number)
    {
        const std::vector<std::string> job = lines_of(files.with(".job"));
        const std::vector<std::string> runs = lines_of(files.with(".runs"));
        const std::set<std::size_t> tasks =
            job.empty() || runs.empty() ? std::set<std::size_t>() : queued_tasks(job.front());
        for (std::size_t i = 0; i < runs.size(); ++i)
        {
            if (tasks.contains(i % task_count(runs.size())))
            {
                names.insert(runs[i]);
            }
        }
    }
    return names;
}

std::string batch_lines(const EngineOptions& engine, const fs::path& log)
{
    std::string text;
    const auto add = [&](const char* option, const std::string& value)
    { text += value.empty() ? "" : fmt::format("#SBATCH --{}={}\n", option, value); };
    add("partition", engine.partition);
    add("account", engine.account);
    add("time", engine.time);
    add("mem", engine.memory);
    add("cpus-per-task", std::to_string(engine.cpus));
    text += fmt::format("#SBATCH --output=\"{}\"\n#SBATCH --open-mode=append\n", log.string());
    std::vector<std::string> lines = engine.lines; // sbatch reads its options up to the first command
    std::ranges::stable_partition(lines, [](const std::string& line) { return line.starts_with("#SBATCH"); });
    for (const std::string& line : lines)
    {
        text += line + "\n";
    }
    return text;
}

std::string array_script(const Submission& submission, const Files& files, std::size_t runs)
{
    const std::size_t tasks = task_count(runs);
    std::string text =
        fmt::format("#!/bin/bash\n#SBATCH --job-name={}\n#SBATCH --array=0-{}", submission.name, tasks - 1);
    text += submission.jobs > 0 ? fmt::format("%{}\n", submission.jobs) : "\n";
    text += "#SBATCH --requeue\n#SBATCH --signal=TERM@120\n" + batch_lines(submission.engine, files.with("_%a.log"));
    const std::vector<std::string> program{submission.command};
    const std::vector<std::string> out{submission.out.string()};
    const std::vector<std::string> list{files.with(".runs").string()};
    text += fmt::format("mapfile -t names < {}\nout={}\nstatus=0\n", shell_line(list), shell_line(out));
    text += fmt::format("for ((i = SLURM_ARRAY_TASK_ID; i < ${{#names[@]}}; i += {})); do\n", tasks);
    text += "    name=${names[i]}\n    failure=$out/slurm/$name.failed\n    rm -f \"$failure\"\n";
    text += fmt::format("    srun --cpus-per-task=\"$SLURM_CPUS_PER_TASK\" {} run \"$out/cases/$name.toml\" \\\n"
                        "        --out \"$out/runs/$name\" --resume --quiet --threads \"$SLURM_CPUS_PER_TASK\" \\\n"
                        "        2> >(tee \"$failure.tmp\" >&2)\n",
                        shell_line(program));
    return text + fmt::format("    ended=$?\n"
                              "    wait\n"
                              "    if ((ended == 130)); then # interrupted, with a checkpoint: go on in the next slot\n"
                              "        ((${{SLURM_RESTART_COUNT:-0}} < {})) && scontrol requeue \"$SLURM_JOB_ID\"\n"
                              "        exit 130\n"
                              "    fi\n"
                              "    if ((ended == 2 || ended == 3)); then\n"
                              "        grep \"^{}\" \"$failure.tmp\" >\"$failure\"\n"
                              "    fi\n"
                              "    rm -f \"$failure.tmp\"\n"
                              "    ((ended == 0)) || status=$ended\n"
                              "done\n"
                              "exit \"$status\"\n",
                              most_restarts, error_prefix);
}

std::string gathering_script(const Submission& submission, const Files& files)
{
    return fmt::format("#!/bin/bash\n#SBATCH --job-name={}_gather\n", submission.name) +
           batch_lines(submission.engine, files.with("_gather.log")) + "exec " + shell_line(submission.gather) + "\n";
}

} // namespace

std::string shell_line(std::span<const std::string> words)
{
    std::vector<std::string> quoted;
    for (const std::string& word : words)
    {
        quoted.push_back(shell_word(word));
    }
    return fmt::format("{}", fmt::join(quoted, " "));
}

std::string task_failure(const fs::path& out, const std::string& run)
{
    const std::vector<std::string> lines = lines_of(out / "slurm" / (run + ".failed"));
    return lines.empty() ? "" : lines.front().substr(std::string_view(error_prefix).size());
}

SubmittedJobs submit(const Submission& submission, std::vector<SweepJob> jobs)
{
    Files files{submission.out / "slurm"};
    const std::set<std::string> queued = queued_runs(files.folder);
    SubmittedJobs result;
    result.queued =
        std::erase_if(jobs, [&](const SweepJob& job) { return queued.contains(job.folder.filename().string()); });
    result.runs = jobs.size();
    if (jobs.empty())
    {
        return result;
    }
    std::ranges::stable_sort(jobs, std::greater<>{}, &SweepJob::cost);
    std::string names;
    for (const SweepJob& job : jobs)
    {
        names += job.folder.filename().string() + "\n";
    }
    fs::create_directories(files.folder);
    while (fs::exists(files.with(".sh")))
    {
        ++files.number;
    }
    formats::write_text_atomically(files.with(".runs"), names);
    formats::write_text_atomically(files.with(".sh"), array_script(submission, files, jobs.size()));
    formats::write_text_atomically(files.with("_gather.sh"), gathering_script(submission, files));
    result.array = sbatch(files.with(".sh"), "");
    formats::write_text_atomically(files.with(".job"), result.array + "\n");
    result.gathering = sbatch(files.with("_gather.sh"), result.array);
    return result;
}

} // namespace corticle::sweep
