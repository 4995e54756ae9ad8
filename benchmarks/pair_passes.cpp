// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/ball.hpp"
#include "benchmarks/counters.hpp"
#include "benchmarks/pair_model.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"

#include <chrono>
#include <limits>

namespace corticle::bench
{
namespace
{

constexpr double growth_time = 0.1;
constexpr double stretch = 1.05;

/// A solver, positions that are sound, and the same with one particle nowhere. An evaluation of these ends after its
/// first pass, since the neighbours of that particle have no valid F: so both passes are timed through the one function
/// there is.
class Passes
{
  public:
    explicit Passes(const Ball& ball)
        : solver_(ball.particles, ball.tissue()), x_(ball.particles.X), forces_(ball.particles.X.size())
    {
        for (Vec3& x : x_)
        {
            x *= stretch;
        }
        unsound_ = x_;
        unsound_.front().x = std::numeric_limits<double>::quiet_NaN();
    }

    bool both() { return solver_.evaluate(x_, growth_time, forces_).invalid_at < 0; }
    bool first() { return solver_.evaluate(unsound_, growth_time, forces_).invalid_at >= 0; }

  private:
    tlsph::TlsphSolver solver_;
    std::vector<Vec3> x_;
    std::vector<Vec3> unsound_;
    std::vector<Vec3> forces_;
};

void report(benchmark::State& state, const Ball& ball, const PassModel& model)
{
    const auto particles = static_cast<double>(ball.particles.X.size());
    count_particles(state, particles);
    count_pairs(state, particles, ball.pairs);
    state.counters["GB_per_s"] = billions(model.bytes(particles, ball.pairs));
    state.counters["GFLOP_per_s"] = billions(model.operations(particles, ball.pairs));
    state.counters["working_set_MB"] = 1e-6 * model.bytes(particles, ball.pairs);
}

double seconds_of(const auto& call)
{
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void force_evaluation(benchmark::State& state)
{
    const Ball& ball = made_for<Ball>(state.range(0));
    Passes passes(ball);
    if (!passes.both())
    {
        state.SkipWithError("the state is invalid");
    }
    for (auto _ : state)
    {
        passes.both();
    }
    report(state, ball, both_passes);
}

void deformation_and_stress(benchmark::State& state)
{
    const Ball& ball = made_for<Ball>(state.range(0));
    Passes passes(ball);
    if (!passes.first())
    {
        state.SkipWithError("the state is valid");
    }
    for (auto _ : state)
    {
        passes.first();
    }
    report(state, ball, deformation_pass);
}

/// What a whole evaluation takes more than one that ends after the first pass; of each the fastest so far, since the
/// difference of two times that differ by chance says little.
void neighbor_forces(benchmark::State& state)
{
    const Ball& ball = made_for<Ball>(state.range(0));
    Passes passes(ball);
    double first = std::numeric_limits<double>::infinity();
    double both = first;
    for (auto _ : state)
    {
        first = std::min(first, seconds_of([&] { passes.first(); }));
        both = std::min(both, seconds_of([&] { passes.both(); }));
        state.SetIterationTime(std::max(1e-9, both - first));
    }
    report(state, ball, force_pass);
}

const bool registered = register_by_size({{"force_evaluation", force_evaluation},
                                          {"deformation_and_stress", deformation_and_stress},
                                          {"neighbor_forces", neighbor_forces, Timing::by_hand}});

} // namespace
} // namespace corticle::bench
