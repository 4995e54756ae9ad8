// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/observer.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace corticle::regions
{

/// What `corticle regions` was asked for.
struct RegionsRequest
{
    std::filesystem::path case_file;    ///< with map.region_file, and a map.region_table to start from
    std::filesystem::path areas;        ///< CSV: label, area_mm2
    std::optional<double> week;         ///< of these areas; of a case without a clock the end of the run
    std::filesystem::path out;          ///< folder of the results
    std::vector<std::string> overrides; ///< "section.key=value"
    int rounds = 8;                     ///< runs at most
    double tolerance = 0.01;            ///< of the areas
    int threads = 0;                    ///< of each run; 0: all cores
    bool quiet = false;
    std::string command = "/proc/self/exe";
};

/// A region in one run.
struct RegionRound
{
    double growth = 1.0; ///< factor of its growth
    double area = 0.0;   ///< at the end [mm²]
};

struct Region
{
    double first_area = 0.0;           ///< of the body at the start [mm²]
    double wanted_area = 0.0;          ///< [mm²]
    std::vector<RegionRound> rounds{}; ///< one for each run

    /// Of the area in a round from the one that is wanted, over this.
    double error(std::size_t round) const { return rounds[round].area / wanted_area - 1.0; }
};

/// Regions by label; those without an area that is wanted keep the factor they have and are not here.
using Regions = std::map<std::int64_t, Region>;

/// The factor to try next: the growth in length that is wanted, sqrt(area ratio) - 1, over that which came, at most
/// doubled or halved. 0 is the least and 10 the most.
double next_growth(const Region& region);

/// The largest error of a round, and the root of the mean square, weighted with the wanted area.
struct RoundError
{
    double largest = 0.0;
    double mean = 0.0;
};
RoundError round_error(const Regions& regions, std::size_t round);

/// Finds how much each region grows, so that the run of a case brings its areas to those of a later brain: runs the
/// case, corrects each factor by what came of it, and runs again. Writes growth.csv (of the best round), regions.csv,
/// regions.json, regions.md, best.toml and runs/KEY; made again it goes on with the runs that are there.
/// @throws InputError before anything is written; RunError when a run fails
model::RunStatus regional_growth(const RegionsRequest& request);

} // namespace corticle::regions
