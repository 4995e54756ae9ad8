// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_runs.hpp"

#include <map>

namespace corticle::sweep
{

/// How a run of a sweep stands.
struct RunState
{
    std::string status = "pending";        ///< "completed" | "failed" | "interrupted" | "pending"
    std::string reason;                    ///< of a failure
    std::string version;                   ///< of the program that ended it
    std::map<std::string, double> numbers; ///< those of summary.json
    std::vector<std::string> warnings;     ///< those of run.log, each once

    bool is_finished() const { return status == "completed" || status == "failed"; }
};

/// From its summary.json and run.log; pending where there is no summary.
RunState read_state(const std::filesystem::path& run_folder);

/// Run folders of a sweep, one for each run; runs of the same case share one.
struct RunFolders
{
    std::vector<std::filesystem::path> of_run; ///< absolute
    std::size_t unused = 0;                    ///< folders with other cases, which are left alone
};

/// Finds for each run the folder in OUT/runs that holds a run of the same case, else a free one named after it.
RunFolders assign_folders(const std::filesystem::path& out, std::span<const SweepRun> runs);

} // namespace corticle::sweep
