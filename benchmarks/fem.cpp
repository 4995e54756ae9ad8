// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/options.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/model/terms.hpp"
#include "corticle/prepare/prepare.hpp"

#include <benchmark/benchmark.h>

namespace corticle
{
namespace
{

model::Model sphere_of_tets(std::int64_t tets, config::Options& options)
{
    options.method = model::Method::fem;
    options.elements = tets;
    options.tissue.layer = material::Layer::binary;
    options.tissue.lambda = 0.75;
    return prepare::prepare_body(options).model;
}

void by_tets(benchmark::internal::Benchmark* made)
{
    for (const std::int64_t tets : {4000, 50000, 223000})
    {
        made->Arg(tets);
    }
    made->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

void report(benchmark::State& state, const model::Model& model)
{
    const auto each = static_cast<double>(state.iterations());
    const auto tets = static_cast<double>(model.fem->elements.tets.size());
    state.counters["ns_per_tet"] =
        benchmark::Counter(each * tets * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Both passes over the tets of the unfolded sphere, without contact.
void tet_forces(benchmark::State& state)
{
    config::Options options;
    const model::Model model = sphere_of_tets(state.range(0), options);
    model::State start;
    start.elements = material::start_tissue(model.fem->tissue, options.tissue, {}, 0.0);
    const Share share(std::ssize(model.cloud.positions));
    const auto solver = model::make_discretization(model, options, start, nullptr, share);
    std::vector<Vec3> forces(model.cloud.positions.size());
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(solver->evaluate(model.cloud.positions, 0.1, forces));
    }
    report(state, model);
}
BENCHMARK(tet_forces)->Apply(by_tets);

/// A whole step of the unfolded sphere: forces, contact search, integration.
void tet_step(benchmark::State& state)
{
    config::Options options;
    const auto model = std::make_shared<const model::Model>(sphere_of_tets(state.range(0), options));
    model::Simulation simulation(model, options);
    for (auto _ : state)
    {
        simulation.step(1.0);
    }
    report(state, *model);
}
BENCHMARK(tet_step)->Apply(by_tets);

} // namespace
} // namespace corticle
