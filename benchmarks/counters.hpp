// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <initializer_list>
#include <memory>

namespace corticle::bench
{

/// Particles of a body, as the benchmarks are asked for them. The first is for the quick run that tests make.
inline constexpr std::int64_t sizes[] = {4000, 32000, 200000, 1000000};

/// T(size), kept until another size is asked for: what benchmarks that follow one another share.
template <class T>
T& made_for(std::int64_t size)
{
    static std::unique_ptr<T> made;
    static std::int64_t made_size = 0;
    if (made_size != size)
    {
        made.reset();
        made = std::make_unique<T>(size);
        made_size = size;
    }
    return *made;
}

enum class Timing
{
    wall,
    by_hand,
    once_by_hand
};

struct Entry
{
    const char* name;
    void (*run)(benchmark::State&);
    Timing timing = Timing::wall;
};

/// Makes them known to Google Benchmark, all of a size before the next.
inline bool register_by_size(std::initializer_list<Entry> entries)
{
    for (const std::int64_t size : sizes)
    {
        for (const Entry& entry : entries)
        {
            auto* made = benchmark::RegisterBenchmark(entry.name, entry.run)->Arg(size)->Unit(benchmark::kMillisecond);
            entry.timing == Timing::wall ? made->UseRealTime() : made->UseManualTime();
            if (entry.timing == Timing::once_by_hand)
            {
                made->Iterations(1);
            }
        }
    }
    return true;
}

/// Seconds spent on one thing: 1e6 for microseconds, for `count` things in each iteration.
inline benchmark::Counter time_each(double count, double unit)
{
    return {count / unit, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

/// Billions per second of what there is `count` of in each iteration.
inline benchmark::Counter billions(double count)
{
    return {count * 1e-9, benchmark::Counter::kIsIterationInvariantRate};
}

inline void count_particles(benchmark::State& state, double particles)
{
    state.counters["us_per_particle_step"] = time_each(particles, 1e6);
}

inline void count_pairs(benchmark::State& state, double particles, double pairs)
{
    state.counters["ns_per_pair"] = time_each(pairs, 1e9);
    state.counters["neighbors"] = pairs / particles;
}

} // namespace corticle::bench
