// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/run_folder.hpp"
#include "corticle/study/sweep/sweep_engine.hpp"

#include <string>
#include <vector>

namespace corticle::sweep
{

/// What `corticle sweep` was asked for.
struct SweepRequest
{
    std::filesystem::path file;
    std::filesystem::path out;          ///< folder of the sweep
    std::vector<std::string> overrides; ///< "section.key=value" for all runs
    std::vector<std::string> only;      ///< runs to make: numbers, names, "section.key=value"; empty: all
    int jobs = 0;                       ///< runs side by side; 0: as many as there are cores
    int threads_per_run = 0;            ///< 0: so that the runs fill the cores
    bool retry = false;                 ///< go on with runs that failed
    bool cases_only = false;            ///< write the cases of the runs and make none
    bool gather = false;                ///< make no runs, write the tables and pictures of those that are there
    Engine engine = Engine::local;
    bool list = false; ///< say how the runs stand, write nothing
    bool quiet = false;
    std::string command = "/proc/self/exe"; ///< started as `COMMAND run CASE --out FOLDER ...`
};

/// Makes the runs of a sweep side by side, each in a process of its own and in its own folder OUT/runs/NAME, and
/// gathers them into OUT/sweep.csv, sweep.md, sweep.json and pictures. Finished runs of the same resolved case are
/// kept, unfinished ones go on from their checkpoints; a run that fails is a row with its reason. Other engines print
/// or submit the unfinished runs; when they have ended, `gather` makes the tables.
/// @throws InputError before anything is written; RunError when the tables cannot be written
model::RunStatus sweep(const SweepRequest& request);

} // namespace corticle::sweep
