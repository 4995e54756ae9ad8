// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/ball.hpp"
#include "benchmarks/counters.hpp"

namespace corticle::bench
{
namespace
{

struct SupportedCloud
{
    explicit SupportedCloud(std::int64_t count)
        : cloud(jittered_ball(count)), support(support_for(usual_neighbors, cloud))
    {
    }

    Cloud cloud;
    double support;
};

void neighbor_search(benchmark::State& state)
{
    const auto& [cloud, support] = made_for<SupportedCloud>(state.range(0));
    double pairs = 0.0;
    for (auto _ : state)
    {
        pairs = static_cast<double>(cloud::find_pairs_within(cloud.positions, support).index.size());
    }
    const auto particles = static_cast<double>(cloud.positions.size());
    count_particles(state, particles);
    count_pairs(state, particles, pairs);
}

/// Weights and gradient corrections of pairs that are found.
void pair_weights(benchmark::State& state)
{
    const auto& [cloud, support] = made_for<SupportedCloud>(state.range(0));
    tlsph::TlsphOptions options;
    options.support = support;
    const Neighbors neighbors = cloud::find_pairs_within(cloud.positions, support);
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(tlsph::make_particles(cloud, neighbors, options));
    }
    const auto particles = static_cast<double>(cloud.positions.size());
    count_particles(state, particles);
    count_pairs(state, particles, static_cast<double>(neighbors.index.size()));
}

const bool registered = register_by_size({{"neighbor_search", neighbor_search}, {"pair_weights", pair_weights}});

} // namespace
} // namespace corticle::bench
