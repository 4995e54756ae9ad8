// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/result_folder.hpp"
#include "corticle/study/comparison/comparison.hpp"
#include "corticle/study/sweep/sweep_folder.hpp"

namespace corticle::sweep
{

/// How far J of a run is from that of its reference run.
struct JDifference
{
    double mean = std::numeric_limits<double>::quiet_NaN();  ///< thesis eq. 27
    double t = std::numeric_limits<double>::quiet_NaN();     ///< growth time at which it was taken
    double error = std::numeric_limits<double>::quiet_NaN(); ///< of interpolation; 0 where the points are the same
};

/// One run of a sweep in the table.
struct SweepRow
{
    std::size_t run = 0;          ///< number, from 0
    std::filesystem::path folder; ///< relative to that of the sweep
    RunState state;
    bool is_kept = false;         ///< finished before this call
    std::vector<double> measures; ///< as many as the sweep has; NaN where there is none
    std::string reference;        ///< name of the run that J is compared to; empty: none
    std::vector<JDifference> J;   ///< from that run: at each compare_t of the sweep, or once

    /// A number of summary.json; NaN where there is none.
    double number(const std::string& key) const;
    /// Wall time of a step, everything included [s].
    double step_s() const;
};

/// A sweep and how its runs stand.
struct SweepTable
{
    SweepFile sweep;
    std::vector<SweepRun> runs;
    std::filesystem::path out;
    std::vector<SweepRow> rows; ///< one for each run, in order
};

/// @throws InputError for a measure that no run has
void require_known_measures(const SweepFile& sweep);

/// Measures of a run, from its summary.json and, at a given time, interpolated in its measures.csv.
void read_measures(const SweepTable& table, SweepRow& row);

/// Compares J of every run that has output times with that of its reference run.
void compare_to_references(SweepTable& table);

/// sweep.csv, one row a run.
std::string sweep_csv(const SweepTable& table);

/// sweep.md: the same as a table for people, the failures with their reasons, and links to the pictures.
std::string sweep_markdown(const SweepTable& table, const study::Pictures& pictures);

/// sweep.json: all that is known.
std::string sweep_json(const SweepTable& table, const study::Pictures& pictures);

/// The pictures that draw_sweep may draw, relative to the folder of the sweep.
std::vector<std::string> sweep_pictures(const SweepTable& table);

/// Draws plots/*.png, the measures and the running time against each axis, and surfaces.png, all surfaces at the end of
/// their runs, into the folder of the sweep. @throws RunError
study::Pictures draw_sweep(const SweepTable& table, record::ResultFolder& folder);

} // namespace corticle::sweep
