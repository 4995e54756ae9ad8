// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/counters.hpp"
#include "corticle/base/parallel.hpp"

#include <vector>

// What the machine can do, by the same threads as the rest: what the other figures are held against.

namespace corticle::bench
{
namespace
{

/// a = b + s c over arrays of together the given MB, as in STREAM (McCalpin 1995), which counts 24 bytes each: the line
/// that is read before it is written is not counted. Best of the repetitions counts.
void triad(benchmark::State& state)
{
    const std::int64_t count = state.range(0) * 1'000'000 / 24;
    std::vector<double> a(static_cast<std::size_t>(count));
    const std::vector<double> b(a.size(), 1.0);
    const std::vector<double> c(a.size(), 2.0);
    const auto sweep = [&]
    {
        parallel_blocks(count,
                        [&, out = a.data(), in = b.data(), other = c.data()](std::int64_t begin, std::int64_t end)
                        {
                            for (std::int64_t i = begin; i < end; ++i)
                            {
                                out[i] = in[i] + 3.0 * other[i];
                            }
                        });
    };
    sweep();
    for (auto _ : state)
    {
        sweep();
        benchmark::ClobberMemory();
    }
    state.counters["GB_per_s"] = billions(24.0 * static_cast<double>(count));
    state.counters["working_set_MB"] = static_cast<double>(state.range(0));
}
// Within the caches of a core, at the size of some ten thousand particles, and beyond any cache.
BENCHMARK(triad)->Arg(1)->Arg(3)->Arg(30)->Arg(300)->Arg(3000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Fused multiply-adds that wait for nothing but the unit that does them: `sums` independent ones.
template <class Lanes, int sums>
[[gnu::always_inline]] inline double multiply_add(std::int64_t rounds)
{
    Lanes sum[sums]{};
    for (int k = 0; k < sums; ++k)
    {
        sum[k] += 1e-3 * k;
    }
    const Lanes factor = Lanes{} + 0.999999;
    const Lanes summand = Lanes{} + 1e-6;
    for (std::int64_t round = 0; round < rounds; ++round)
    {
        for (int k = 0; k < sums; ++k)
        {
            sum[k] = sum[k] * factor + summand;
        }
    }
    double total = 0.0;
    for (int k = 0; k < sums; ++k)
    {
        total += sum[k][0];
    }
    return total;
}

constexpr int many_sums = 12;
using Lanes2 = double __attribute__((vector_size(16)));
double multiply_add_baseline(std::int64_t rounds)
{
    return multiply_add<Lanes2, many_sums>(rounds);
}

struct Arithmetic
{
    double (*run)(std::int64_t rounds);
    double operations_per_round;
};

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
using Lanes4 = double __attribute__((vector_size(32)));
using Lanes8 = double __attribute__((vector_size(64)));
[[gnu::target("arch=x86-64-v3")]] double multiply_add_v3(std::int64_t rounds)
{
    return multiply_add<Lanes4, many_sums>(rounds);
}
[[gnu::target("arch=x86-64-v4")]] double multiply_add_v4(std::int64_t rounds)
{
    return multiply_add<Lanes8, many_sums>(rounds);
}

Arithmetic best_arithmetic()
{
    if (__builtin_cpu_supports("x86-64-v4"))
    {
        return {multiply_add_v4, 2.0 * 8 * many_sums};
    }
    if (__builtin_cpu_supports("x86-64-v3"))
    {
        return {multiply_add_v3, 2.0 * 4 * many_sums};
    }
    return {multiply_add_baseline, 2.0 * 2 * many_sums};
}
#else
Arithmetic best_arithmetic()
{
    return {multiply_add_baseline, 2.0 * 2 * many_sums};
}
#endif

void fma_peak(benchmark::State& state)
{
    constexpr std::int64_t rounds = 20000;
    constexpr std::int64_t blocks = 64;
    const Arithmetic arithmetic = best_arithmetic();
    for (auto _ : state)
    {
        parallel_blocks(blocks * parallel_block,
                        [&](std::int64_t, std::int64_t) { benchmark::DoNotOptimize(arithmetic.run(rounds)); });
    }
    state.counters["GFLOP_per_s"] = billions(arithmetic.operations_per_round * rounds * blocks);
}
BENCHMARK(fma_peak)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace corticle::bench
