// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpointing.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/version.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/metrics/measure_table.hpp"

#include <fmt/format.h>

namespace corticle::record
{

namespace
{

constexpr std::size_t clock_size = 9;
constexpr std::size_t counters_size = 4;
constexpr std::string_view history_prefix = "history.";

std::string column_name(const metrics::MeasureColumn& column)
{
    return "measures." + std::string(column.key);
}

/// What a checkpoint must hold for this version to go on from it.
class Entries
{
  public:
    Entries(const Checkpoint& checkpoint, const std::string& file) : checkpoint_(checkpoint), file_(file) {}

    const std::vector<Vec3>& vectors(const std::string& name, std::size_t size) const
    {
        return entry(checkpoint_.vectors, name, size);
    }
    const std::vector<double>& clock() const { return entry(checkpoint_.scalars, "clock", clock_size); }
    const std::vector<std::int64_t>& counters() const { return entry(checkpoint_.integers, "counters", counters_size); }
    const std::vector<double>& column(const metrics::MeasureColumn& column) const
    {
        return entry(checkpoint_.scalars, column_name(column), static_cast<std::size_t>(counters()[3]));
    }

  private:
    template <class Map>
    const typename Map::mapped_type& entry(const Map& map, const std::string& name, std::size_t size) const
    {
        const auto found = map.find(name);
        if (found == map.end() || found->second.size() != size)
        {
            const std::string& writer = checkpoint_.program_version;
            formats::fail_reading(file_,
                                  fmt::format("a checkpoint that version {} wrote and this one cannot go on from",
                                              writer.empty() ? "unknown" : writer),
                                  fmt::format("{} values of {}", found == map.end() ? 0 : found->second.size(), name),
                                  fmt::format("{}, as version {} writes them", size, program_version()));
        }
        return found->second;
    }

    const Checkpoint& checkpoint_;
    const std::string& file_;
};

} // namespace

std::string versions_after(const std::string& earlier)
{
    const std::string now(program_version());
    if (earlier.empty())
    {
        return now;
    }
    return earlier == now || earlier.ends_with(", " + now) ? earlier : earlier + ", " + now;
}

Checkpoint to_checkpoint(const model::State& state, std::span<const metrics::Measures> rows,
                         const std::string& case_text, const std::string& versions)
{
    Checkpoint checkpoint;
    checkpoint.program_version = versions;
    checkpoint.case_text = case_text;
    checkpoint.vectors["position"] = state.motion.x;
    checkpoint.vectors["velocity"] = state.motion.v;
    checkpoint.scalars["clock"] = {state.t,
                                   state.step_scale,
                                   state.kinetic_energy,
                                   state.energy_balance.growth_work,
                                   state.energy_balance.dissipated,
                                   state.lowest_gi_sphere,
                                   state.onset_t,
                                   state.loading_rate,
                                   state.travel_taken.energy};
    checkpoint.integers["counters"] = {state.steps, state.rejected_steps, state.travel_taken.vertex_steps,
                                       static_cast<std::int64_t>(rows.size())};
    for (const auto& [name, values] : state.history)
    {
        checkpoint.scalars[std::string(history_prefix) + name] = values;
    }
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        std::vector<double>& values = checkpoint.scalars[column_name(column)];
        for (const metrics::Measures& row : rows)
        {
            values.push_back(column.of(row));
        }
    }
    return checkpoint;
}

double reached_time(const Checkpoint& checkpoint, const std::string& file)
{
    const Entries entries(checkpoint, file);
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        entries.column(column);
    }
    return entries.clock().front();
}

Restored from_checkpoint(const Checkpoint& checkpoint, std::size_t particles, const std::string& file)
{
    const Entries entries(checkpoint, file);
    Restored restored;
    model::State& state = restored.state;
    state.motion.x = entries.vectors("position", particles);
    state.motion.v = entries.vectors("velocity", particles);
    const std::vector<double>& clock = entries.clock();
    state.t = clock[0];
    state.step_scale = clock[1];
    state.kinetic_energy = clock[2];
    state.energy_balance = {clock[3], clock[4]};
    state.lowest_gi_sphere = clock[5];
    state.onset_t = clock[6];
    state.loading_rate = clock[7];
    state.travel_taken.energy = clock[8];
    const std::vector<std::int64_t>& counters = entries.counters();
    state.steps = counters[0];
    state.rejected_steps = counters[1];
    state.travel_taken.vertex_steps = counters[2];
    for (const auto& [name, values] : checkpoint.scalars)
    {
        if (name.starts_with(history_prefix))
        {
            state.history[name.substr(history_prefix.size())] = values;
        }
    }
    restored.rows.resize(static_cast<std::size_t>(counters[3]));
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        const std::vector<double>& values = entries.column(column);
        for (std::size_t k = 0; k < values.size(); ++k)
        {
            column.in(restored.rows[k]) = values[k];
        }
    }
    return restored;
}

} // namespace corticle::record
