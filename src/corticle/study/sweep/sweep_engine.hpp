// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/choices.hpp"
#include "corticle/study/sweep/sweep_place.hpp"

namespace corticle::sweep
{

/// Who makes the runs of a sweep.
enum class Engine
{
    local,    ///< processes of this machine, waited for
    commands, ///< nobody: the command of each run is printed
    slurm     ///< an array job of Slurm, submitted and not waited for
};

/// What an array job asks for: the [engine] table of a sweep.
struct EngineOptions
{
    std::string partition; ///< empty: Slurm's default, as with account, time and memory
    std::string account;
    std::string time; ///< of one task, as sbatch takes it: "02:00:00"
    std::string memory;
    int cpus = 1; ///< of one task, threads of its run
    std::vector<std::string>
        lines; ///< of the script, before its commands: "#SBATCH --constraint=...", "module load ..."
};

/// The [engine] table. @throws InputError for an unknown key, a wrong type or range
EngineOptions read_engine(const config::TomlNode& node, const SweepPlace& place);

} // namespace corticle::sweep

namespace corticle::config
{

template <>
inline std::vector<std::string> names<sweep::Engine>()
{
    return {"local", "commands", "slurm"};
}

} // namespace corticle::config
