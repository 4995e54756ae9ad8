// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_engine.hpp"
#include "corticle/study/sweep/sweep_jobs.hpp"

#include <filesystem>

namespace corticle::sweep
{

/// Words as one line that a shell takes apart again.
std::string shell_line(std::span<const std::string> words);

/// Why a task could not make a run, of which nothing is in its folder; else empty.
std::string task_failure(const std::filesystem::path& out, const std::string& run);

/// What is submitted to Slurm.
struct Submission
{
    std::filesystem::path out; ///< folder of the sweep; scripts, logs and job numbers go to OUT/slurm
    std::string name;          ///< of the job
    EngineOptions engine;
    std::string command;             ///< absolute path of the program
    int jobs = 0;                    ///< tasks at a time; 0: no limit
    std::vector<std::string> gather; ///< words of the command that gathers the runs
};

/// Numbers of the jobs, and how many runs they make.
struct SubmittedJobs
{
    std::string array;     ///< empty: no run was left to submit
    std::string gathering; ///< starts when the array has ended, however
    std::size_t runs = 0;
    std::size_t queued = 0; ///< runs left to tasks of earlier array jobs that are still in the queue
};

/// Submits an array job for those runs that no earlier array job of this sweep still has in the queue, and a job that
/// gathers them. A task makes its runs one after the other, each from its checkpoint; when Slurm asks it to end, or it
/// is requeued, it goes on in its next slot.
/// @throws RunError when sbatch is not there or refuses
SubmittedJobs submit(const Submission& submission, std::vector<SweepJob> jobs);

} // namespace corticle::sweep
