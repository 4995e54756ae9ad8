// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpointing.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/version.hpp"

#include <fmt/format.h>

namespace corticle
{

namespace
{

template <class Map>
const typename Map::mapped_type& entry(const Map& map, const std::string& name, std::size_t size,
                                       const std::string& file)
{
    const auto found = map.find(name);
    if (found == map.end() || found->second.size() != size)
    {
        throw InputError(fmt::format("{}: checkpoint holds {} values of {}; expected {}", file,
                                     found == map.end() ? 0 : found->second.size(), name, size));
    }
    return found->second;
}

constexpr std::size_t clock_size = 9;

std::string column_name(const MeasureColumn& column)
{
    return "measures." + std::string(column.key);
}

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

Checkpoint to_checkpoint(const State& state, std::span<const Measures> rows, const std::string& case_text,
                         const std::string& versions)
{
    Checkpoint checkpoint;
    checkpoint.program_version = versions;
    checkpoint.case_text = case_text;
    checkpoint.vectors["position"] = state.motion.x;
    checkpoint.vectors["velocity"] = state.motion.v;
    checkpoint.scalars["clock"] = {state.t,
                                   state.step_scale,
                                   state.kinetic_energy,
                                   state.books.growth_work,
                                   state.books.dissipated,
                                   state.lowest_gi_sphere,
                                   state.onset_t,
                                   state.loading_rate,
                                   state.travel_taken.energy};
    checkpoint.integers["counters"] = {state.steps, state.rejected_steps, state.travel_taken.vertex_steps,
                                       static_cast<std::int64_t>(rows.size())};
    for (const MeasureColumn& column : measure_columns())
    {
        std::vector<double>& values = checkpoint.scalars[column_name(column)];
        for (const Measures& row : rows)
        {
            values.push_back(row.*column.value);
        }
    }
    return checkpoint;
}

double reached_time(const Checkpoint& checkpoint, const std::string& file)
{
    return entry(checkpoint.scalars, "clock", clock_size, file).front();
}

Restored from_checkpoint(const Checkpoint& checkpoint, std::size_t particles, const std::string& file)
{
    Restored restored;
    State& state = restored.state;
    state.motion.x = entry(checkpoint.vectors, "position", particles, file);
    state.motion.v = entry(checkpoint.vectors, "velocity", particles, file);
    const std::vector<double>& clock = entry(checkpoint.scalars, "clock", clock_size, file);
    state.t = clock[0];
    state.step_scale = clock[1];
    state.kinetic_energy = clock[2];
    state.books = {clock[3], clock[4]};
    state.lowest_gi_sphere = clock[5];
    state.onset_t = clock[6];
    state.loading_rate = clock[7];
    state.travel_taken.energy = clock[8];
    const std::vector<std::int64_t>& counters = entry(checkpoint.integers, "counters", 4, file);
    state.steps = counters[0];
    state.rejected_steps = counters[1];
    state.travel_taken.vertex_steps = counters[2];
    restored.rows.resize(static_cast<std::size_t>(counters[3]));
    for (const MeasureColumn& column : measure_columns())
    {
        const std::vector<double>& values = entry(checkpoint.scalars, column_name(column), restored.rows.size(), file);
        for (std::size_t k = 0; k < values.size(); ++k)
        {
            restored.rows[k].*column.value = values[k];
        }
    }
    return restored;
}

} // namespace corticle
