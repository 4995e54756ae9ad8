// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/regions/regional_growth.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/label_table.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/metrics/region_areas.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/markdown.hpp"
#include "corticle/study/sweep/sweep_jobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace corticle::regions
{

namespace
{

namespace fs = std::filesystem;

using Areas = std::map<std::int64_t, double>;

Areas read_areas(const fs::path& file)
{
    constexpr std::array<std::string_view, 1> used{"area_mm2"};
    const formats::LabelTable table = formats::read_label_table(file, used);
    if (table.columns.empty())
    {
        throw InputError(fmt::format("--areas {}: has no column area_mm2; expected columns label and area_mm2, as "
                                     "`corticle measure --regions` writes them",
                                     file.string()));
    }
    Areas areas;
    for (const auto& [label, values] : table.rows)
    {
        if (values[0] <= 0.0)
        {
            throw InputError(fmt::format("--areas {}: label {} has {:g} mm2; expected an area above 0", file.string(),
                                         label, values[0]));
        }
        areas[label] = values[0];
    }
    return areas;
}

/// Areas of the regions of a frame.
Areas areas_of(const fs::path& surface_file)
{
    const formats::SurfaceFile surface = formats::read_surface_vtp(surface_file);
    const auto region =
        std::ranges::find(surface.fields, "region", &std::pair<std::string, std::vector<double>>::first);
    if (region == surface.fields.end())
    {
        throw InputError(fmt::format("{}: has no array region", surface_file.string()));
    }
    return metrics::region_areas({surface.mesh.vertices, surface.mesh.triangles}, region->second);
}

constexpr std::array<std::string_view, 3> table_columns{"growth", "onset", "rate"};

/// The table that a case starts from.
formats::LabelTable read_start(const config::Options& options)
{
    const prepare::MapOptions& map = options.map;
    if (map.region_file.empty() || map.region_table.empty())
    {
        throw InputError(
            fmt::format("map.{}: not given; expected labels of regions and a table of their growth to start "
                        "from, as in docs/guide/regional-growth.md",
                        map.region_file.empty() ? "region_file" : "region_table"));
    }
    return formats::read_label_table(map.region_table, table_columns);
}

/// The same table with the growth of a round.
std::string growth_table(const formats::LabelTable& start, const Regions& regions, std::size_t round)
{
    std::string text = fmt::format("label,{}\n", fmt::join(start.columns, ","));
    for (const auto& [label, values] : start.rows)
    {
        std::vector<double> row = values;
        const auto found = regions.find(label);
        if (found != regions.end())
        {
            row[static_cast<std::size_t>(start.column("growth"))] = found->second.rounds[round].growth;
        }
        text += fmt::format("{},{}\n", label, fmt::join(row, ","));
    }
    return text;
}

Regions starting_regions(const RegionsRequest& request, const formats::LabelTable& start, const Areas& wanted)
{
    const std::int64_t growth = start.column("growth");
    Regions regions;
    for (const auto& [label, area] : wanted)
    {
        const auto row = start.rows.find(label);
        if (row == start.rows.end() || growth < 0)
        {
            throw InputError(fmt::format("--areas {}: label {} has no growth in map.region_table; expected labels of "
                                         "that table",
                                         request.areas.string(), label));
        }
        regions[label] = {0.0, area, {{row->second[static_cast<std::size_t>(growth)], 0.0}}};
    }
    return regions;
}

/// The case with growth from a table, to the week of the areas. @param table  empty: its own
config::Options case_options(const RegionsRequest& request, const fs::path& table)
{
    std::vector<std::string> overrides = request.overrides;
    if (!table.empty())
    {
        overrides.push_back(fmt::format("map.region_table=\"{}\"", table.string()));
    }
    if (request.week)
    {
        overrides.push_back(fmt::format("time.end_week={}", *request.week));
    }
    return config::read_case(request.case_file, overrides);
}

/// The search on its way.
class Search
{
  public:
    /// @throws InputError where the case has no regions, or those of the areas are not among them
    Search(const RegionsRequest& request, const fs::path& out)
        : request_(request), out_(out), start_(read_start(case_options(request, ""))),
          regions_(starting_regions(request, start_, read_areas(request.areas)))
    {
    }

    /// False when interrupted.
    bool find();

    const Regions& regions() const { return regions_; }
    std::size_t best() const { return best_; }
    std::size_t rounds() const { return regions_.begin()->second.rounds.size(); }
    config::Options options(std::size_t round) const { return case_options(request_, table(round)); }
    std::string table_text(std::size_t round) const { return growth_table(start_, regions_, round); }

  private:
    fs::path table(std::size_t round) const { return out_ / "cases" / fmt::format("growth_{}.csv", round + 1); }
    bool run(std::size_t round, fs::path& folder) const;
    void take_areas(std::size_t round, const fs::path& folder);
    void say(std::size_t round) const;

    const RegionsRequest& request_;
    fs::path out_;
    formats::LabelTable start_;
    Regions regions_;
    std::size_t best_ = 0;
};

/// Makes the run of a round, unless it is there: its folder is named after what makes it, the resolved case.
/// @returns false when interrupted
bool Search::run(std::size_t round, fs::path& folder) const
{
    formats::write_text_atomically(table(round), table_text(round));
    config::Options chosen = options(round);
    config::identify_inputs(chosen);
    const std::string key = sweep::run_key(chosen);
    const fs::path case_file = out_ / "cases" / (key + ".toml");
    formats::write_text_atomically(case_file, config::to_toml(chosen));
    folder = out_ / "runs" / key;
    sweep::RunState state = sweep::read_state(folder);
    if (!state.is_finished())
    {
        const study::InterruptionGuard guard;
        const sweep::SweepJob job{case_file, folder, 1.0, chosen.time.start, chosen.time.end, false};
        if (!sweep::make_runs(std::array{job}, {request_.command, 1, request_.threads, 0, true},
                              [&](std::size_t, const sweep::RunState& ended) { state = ended; }))
        {
            return false;
        }
    }
    if (state.status != "completed")
    {
        throw RunError(fmt::format("round {}: {}", round + 1, state.reason));
    }
    return true;
}

void Search::take_areas(std::size_t round, const fs::path& folder)
{
    const std::vector<record::FrameFiles> frames = record::list_frames(folder);
    const Areas first = areas_of(frames.front().surface);
    const Areas last = areas_of(frames.back().surface);
    for (auto& [label, region] : regions_)
    {
        if (!first.contains(label))
        {
            throw InputError(fmt::format("--areas {}: the surface of the body has no vertex of label {}",
                                         request_.areas.string(), label));
        }
        region.first_area = first.at(label);
        region.rounds[round].area = last.at(label);
    }
}

bool Search::find()
{
    for (std::size_t round = 0;; ++round)
    {
        fs::path folder;
        if (!run(round, folder))
        {
            return false;
        }
        take_areas(round, folder);
        best_ = round_error(regions_, round).mean < round_error(regions_, best_).mean ? round : best_;
        say(round);
        if (round_error(regions_, round).largest <= request_.tolerance ||
            round + 1 == static_cast<std::size_t>(request_.rounds))
        {
            return true;
        }
        for (auto& [label, region] : regions_)
        {
            region.rounds.push_back({next_growth(region), 0.0});
        }
    }
}

void Search::say(std::size_t round) const
{
    if (!request_.quiet)
    {
        const RoundError error = round_error(regions_, round);
        fmt::print("round {}: areas off by {:.2f} % (root mean square), {:.2f} % at most\n", round + 1,
                   100.0 * error.mean, 100.0 * error.largest);
        std::fflush(stdout);
    }
}

std::string regions_csv(const Search& search)
{
    std::string text = "label,first_area_mm2,wanted_area_mm2,area_mm2,error_percent,growth\n";
    for (const auto& [label, region] : search.regions())
    {
        const RegionRound& round = region.rounds[search.best()];
        text += fmt::format("{},{},{},{},{},{}\n", label, region.first_area, region.wanted_area, round.area,
                            100.0 * region.error(search.best()), round.growth);
    }
    return text;
}

std::string regions_json(const Search& search)
{
    nlohmann::ordered_json json;
    json["best_round"] = search.best() + 1;
    for (std::size_t round = 0; round < search.rounds(); ++round)
    {
        const RoundError error = round_error(search.regions(), round);
        json["rounds"].push_back({{"largest_error", error.largest}, {"mean_error", error.mean}});
    }
    for (const auto& [label, region] : search.regions())
    {
        const RegionRound& best = region.rounds[search.best()];
        json["regions"][fmt::format("{}", label)] = {{"first_area_mm2", region.first_area},
                                                     {"wanted_area_mm2", region.wanted_area},
                                                     {"area_mm2", best.area},
                                                     {"growth", best.growth}};
    }
    return json.dump(2) + "\n";
}

std::string regions_report(const Search& search)
{
    using study::table_number;
    std::vector<std::vector<std::string>> rounds;
    for (std::size_t round = 0; round < search.rounds(); ++round)
    {
        const RoundError error = round_error(search.regions(), round);
        rounds.push_back({fmt::format("{}", round + 1), fmt::format("{:.2f} %", 100.0 * error.mean),
                          fmt::format("{:.2f} %", 100.0 * error.largest)});
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& [label, region] : search.regions())
    {
        const RegionRound& best = region.rounds[search.best()];
        rows.push_back({fmt::format("{}", label), table_number(region.first_area), table_number(region.wanted_area),
                        table_number(best.area), study::table_percent(100.0 * region.error(search.best())),
                        table_number(best.growth)});
    }
    return "# Growth of regions\n\nErrors are those of the areas from the wanted ones. `best.toml` is the case of the "
           "best "
           "round, `growth.csv` its table.\n\n" +
           study::markdown_table({"round", "root mean square", "largest"}, rounds) +
           fmt::format("## Round {}\n\n", search.best() + 1) +
           study::markdown_table(
               {"region", "area at the start [mm²]", "wanted [mm²]", "reached [mm²]", "error", "growth"}, rows);
}

void write(const Search& search, const fs::path& out)
{
    formats::write_text_atomically(out / "growth.csv", search.table_text(search.best()));
    formats::write_text_atomically(out / "regions.csv", regions_csv(search));
    formats::write_text_atomically(out / "regions.json", regions_json(search));
    config::Options best = search.options(search.best());
    best.map.region_table = (out / "growth.csv").string();
    formats::write_text_atomically(out / "best.toml", config::to_toml(best));
    formats::write_text_atomically(out / "regions.md", regions_report(search));
}

} // namespace

double next_growth(const Region& region)
{
    constexpr double most_change = 2.0;
    constexpr double least = 0.02; // a region that is to grow must have something to multiply
    constexpr double most = 10.0;
    const RegionRound& last = region.rounds.back();
    const double wanted = std::sqrt(region.wanted_area / region.first_area) - 1.0;
    const double came = std::sqrt(last.area / region.first_area) - 1.0;
    const double ratio = came > 0.0 ? wanted / came : wanted > came ? most_change : 1.0 / most_change;
    const double next = std::max(last.growth, least) * std::clamp(ratio, 1.0 / most_change, most_change);
    return std::clamp(next, 0.0, most);
}

RoundError round_error(const Regions& regions, std::size_t round)
{
    RoundError result;
    double weights = 0.0;
    for (const auto& [label, region] : regions)
    {
        const double error = region.error(round);
        result.largest = std::max(result.largest, std::abs(error));
        result.mean += region.wanted_area * error * error;
        weights += region.wanted_area;
    }
    result.mean = std::sqrt(result.mean / weights);
    return result;
}

model::RunStatus regional_growth(const RegionsRequest& request)
{
    const fs::path out = fs::absolute(request.out).lexically_normal();
    Search search(request, out);
    if (record::is_run_folder(out))
    {
        throw InputError(fmt::format("--out {}: holds a run; expected another folder", out.string()));
    }
    record::ResultFolder folder(out, "regions");
    const std::vector<std::string> files{"growth.csv", "regions.csv", "regions.json", "regions.md", "best.toml"};
    folder.require_free(files);
    folder.make();
    folder.remove_leftovers();
    folder.claim(files);
    fs::create_directories(out / "cases");
    if (!search.find())
    {
        return model::RunStatus::interrupted;
    }
    write(search, out);
    if (!request.quiet)
    {
        fmt::print("wrote {}\n", (out / "regions.md").string());
    }
    return model::RunStatus::completed;
}

} // namespace corticle::regions
