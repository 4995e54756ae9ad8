// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/summary.hpp"

#include "corticle/base/version.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/metrics/measure_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace corticle::record
{

namespace
{

/// The value of a key that is text.
std::string text_of(const config::Options& options, std::string_view key)
{
    return std::get<std::string>(config::find_parameter(key)->get(options));
}

/// Mean cost in wall time of one of so many things in one step; null before the first step.
nlohmann::ordered_json cost_each(double seconds, double things, const RunInfo& info)
{
    const double work = things * static_cast<double>(info.session_steps);
    return work > 0.0 ? nlohmann::ordered_json(seconds * info.session_wall_s / work) : nlohmann::ordered_json(nullptr);
}

} // namespace

double peak_memory_mb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string inputs_json(const config::Options& options)
{
    nlohmann::ordered_json j = nlohmann::ordered_json::object();
    for (const auto& [key, checksum] : options.inputs)
    {
        j[key] = {{"file", text_of(options, key)}, {"sha256", checksum}};
    }
    return j.dump();
}

std::string summary_json(const model::Simulation& simulation, const prepare::PreparationReport& made,
                         const config::Options& options, const metrics::Measures& last, const RunInfo& info)
{
    const model::Model& model = simulation.model();
    const model::State& state = simulation.state();
    const auto particles = static_cast<double>(model.cloud.positions.size());
    const std::size_t elements = model.fem ? model.fem->elements.tets.size() : 0;
    nlohmann::ordered_json j;
    j["status"] = info.status;
    if (!info.reason.empty())
    {
        j["reason"] = info.reason;
    }
    j["method"] = text_of(options, "solver.method");
    j["formulation"] = text_of(options, "solver.formulation");
    j["particles"] = model.cloud.positions.size();
    j["surface_particles"] = model.cloud.surface_particles.size();
    j["elements"] = elements;
    j["threads"] = info.threads;
    j["t"] = state.t;
    j["clock"] = text_of(options, "time.clock");
    j["week"] = last.week;
    j["length_scale"] = last.length_scale;
    j["steps"] = state.steps;
    j["rejected_steps"] = state.rejected_steps;
    j["wall_s"] = info.wall_s;
    j["us_per_particle_step"] = cost_each(1e6, particles, info);
    if (model.fem)
    {
        j["ns_per_element_step"] = cost_each(1e9, static_cast<double>(elements), info);
    }
    j["internal_forces_s"] = simulation.seconds_of("tissue");
    j["contact_s"] = simulation.seconds_of("contact");
    j["measures_s"] = info.measures_s;
    j["output_s"] = info.output_s;
    j["peak_memory_mb"] = peak_memory_mb();
    j["onset_t"] = state.onset_t >= 0.0 ? nlohmann::ordered_json(state.onset_t) : nlohmann::ordered_json(nullptr);
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        if (column.key != "contact_pairs" && !j.contains(column.key))
        {
            j[std::string(column.key)] = column.of(last);
        }
    }
    j["spacing_mm"] = model.cloud.spacing;
    j["neighbours_mean"] = made.neighbors_mean;
    j["dropped_pairs"] = made.visibility.dropped_pairs;
    if (made.input_vertices > 0)
    {
        j["remesh_area_change"] = made.remesh.area_change;
        j["remesh_volume_change"] = made.remesh.volume_change;
        j["remesh_largest_distance_mm"] = made.remesh.largest_distance_mm;
    }
    j["inputs"] = nlohmann::ordered_json::parse(inputs_json(options));
    j["version"] = program_version();
    j["versions"] = info.versions;
    return j.dump(2) + "\n";
}

std::string summary_without_state_json(const RunInfo& info)
{
    nlohmann::ordered_json j;
    j["status"] = info.status;
    j["reason"] = info.reason;
    j["threads"] = info.threads;
    j["wall_s"] = info.wall_s;
    j["peak_memory_mb"] = peak_memory_mb();
    j["version"] = program_version();
    j["versions"] = info.versions;
    return j.dump(2) + "\n";
}

std::vector<std::string> summary_number_keys()
{
    std::vector<std::string> keys{"particles",
                                  "surface_particles",
                                  "elements",
                                  "threads",
                                  "wall_s",
                                  "ns_per_element_step",
                                  "us_per_particle_step",
                                  "internal_forces_s",
                                  "contact_s",
                                  "measures_s",
                                  "output_s",
                                  "peak_memory_mb",
                                  "onset_t",
                                  "spacing_mm",
                                  "neighbours_mean",
                                  "dropped_pairs",
                                  "remesh_area_change",
                                  "remesh_volume_change",
                                  "remesh_largest_distance_mm"};
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        if (column.key != "contact_pairs")
        {
            keys.emplace_back(column.key);
        }
    }
    return keys;
}

} // namespace corticle::record
