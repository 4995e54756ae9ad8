// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_folder.hpp"

#include <functional>

namespace corticle::sweep
{

/// A run to be made.
struct SweepJob
{
    std::filesystem::path case_file;
    std::filesystem::path folder;
    double cost = 1.0; ///< relative to other runs
    double t_begin = 0.0;
    double t_end = 1.0;
    bool retry = false; ///< although it failed before
};

/// The command that makes a run, or goes on with it.
std::vector<std::string> run_words(const std::string& command, const SweepJob& job);

/// How runs are made side by side.
struct JobOptions
{
    std::string command;
    int jobs = 0;            ///< 0: as many as there are cores
    int threads_per_run = 0; ///< 0: so that the runs fill the cores
    std::size_t done = 0;    ///< runs finished before, for the line of progress
    bool quiet = false;
};

/// About how long a run takes, relative to other runs: steps, particles and neighbours.
double relative_cost(const config::Options& options);

/// Makes the runs, the costly ones first, each as a process of the command that resumes what its folder holds; a folder
/// that another process holds is waited for. `ended(job, state)` is called after each.
/// To be called while an InterruptionGuard lives.
/// @returns false when interrupted: the processes have been ended, with their checkpoints
bool make_runs(std::span<const SweepJob> jobs, const JobOptions& options,
               const std::function<void(std::size_t, const RunState&)>& ended);

} // namespace corticle::sweep
