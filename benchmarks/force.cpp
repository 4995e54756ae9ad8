// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/body.hpp"
#include "corticle/simulation/simulation.hpp"

#include <benchmark/benchmark.h>

namespace corticle
{
namespace
{

Body standard_sphere(std::int64_t particles, Options& options)
{
    options.tissue.layer = Layer::binary;
    options.tissue.lambda = 0.75;
    options.geometry.particles = particles;
    return prepare_body(options);
}

void report(benchmark::State& state, const Body& body)
{
    const auto each = static_cast<double>(state.iterations());
    const auto particles = static_cast<double>(body.cloud.positions.size());
    const auto pairs = static_cast<double>(body.particles.pairs.place.size());
    state.counters["us_per_particle"] =
        benchmark::Counter(each * particles * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["ns_per_pair"] =
        benchmark::Counter(each * pairs * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["neighbors"] = pairs / particles;
}

/// Both pair passes and the material law of the unfolded sphere, without contact.
void force_evaluation(benchmark::State& state)
{
    Options options;
    const Body body = standard_sphere(state.range(0), options);
    TlsphSolver solver(body.particles, body.tissue);
    std::vector<Vec3> forces(body.cloud.positions.size());
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(solver.evaluate(body.cloud.positions, 0.1, forces));
    }
    report(state, body);
}
BENCHMARK(force_evaluation)->Arg(32000)->Arg(200000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A whole step of the unfolded sphere: forces, contact search, integration.
void whole_step(benchmark::State& state)
{
    Options options;
    Body body = standard_sphere(state.range(0), options);
    Simulation simulation(body, options);
    for (auto _ : state)
    {
        simulation.step(1.0);
    }
    report(state, body);
}
BENCHMARK(whole_step)->Arg(32000)->Arg(200000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace corticle
