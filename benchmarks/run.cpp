// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/counters.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/parameters/options.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/prepare/prepare.hpp"
#include "corticle/record/checkpointing.hpp"
#include "corticle/record/frames.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace corticle::bench
{
namespace
{

/// The standard sphere, from its options to a run at its start.
struct StandardSphere
{
    explicit StandardSphere(std::int64_t particles)
    {
        options.tissue.layer = material::Layer::binary;
        options.tissue.lambda = 0.75;
        options.geometry.particles = particles;
        const auto start = std::chrono::steady_clock::now();
        model = std::make_shared<const model::Model>(prepare::prepare_body(options).model);
        preparation_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        simulation = std::make_unique<model::Simulation>(model, options);
    }
    StandardSphere(const StandardSphere&) = delete;

    double particles() const { return static_cast<double>(model->cloud.positions.size()); }

    config::Options options;
    std::shared_ptr<const model::Model> model;
    double preparation_seconds = 0.0;
    std::unique_ptr<model::Simulation> simulation;
};

/// A folder for what is written, removed at the end.
class ScratchFolder
{
  public:
    ScratchFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "corticle-bench-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }
    double bytes() const
    {
        double sum = 0.0;
        for (const auto& file : std::filesystem::directory_iterator(path_))
        {
            sum += static_cast<double>(file.file_size());
        }
        return sum;
    }

  private:
    std::filesystem::path path_;
};

void report_files(benchmark::State& state, const ScratchFolder& folder)
{
    state.counters["GB_per_s"] = billions(folder.bytes());
    state.counters["written_MB"] = 1e-6 * folder.bytes();
}

/// Surface, cloud, depth, pairs, weights: what `prepare` does to the sphere, timed when it was made.
void cloud_preparation(benchmark::State& state)
{
    const StandardSphere& sphere = made_for<StandardSphere>(state.range(0));
    for (auto _ : state)
    {
        state.SetIterationTime(sphere.preparation_seconds);
    }
    count_particles(state, sphere.particles());
}

/// Forces, contact search, integration of the unfolded sphere.
void whole_step(benchmark::State& state)
{
    StandardSphere& sphere = made_for<StandardSphere>(state.range(0));
    for (auto _ : state)
    {
        sphere.simulation->step(1.0);
    }
    count_particles(state, sphere.particles());
}

/// What is measured on the surface at an output time.
void surface_measures(benchmark::State& state)
{
    const model::Simulation& simulation = *made_for<StandardSphere>(state.range(0)).simulation;
    const model::OutputView view = model::output_view(simulation);
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(metrics::surface_arrays(view));
    }
    count_particles(state, static_cast<double>(view.F->size()));
}

/// The files of an output time.
void frame_files(benchmark::State& state)
{
    const model::Simulation& simulation = *made_for<StandardSphere>(state.range(0)).simulation;
    const model::OutputView view = model::output_view(simulation);
    const metrics::SurfaceArrays arrays = metrics::surface_arrays(view);
    const ScratchFolder folder;
    for (auto _ : state)
    {
        const record::Frame frame = record::make_frame(view, arrays, "0000");
        record::write_frame(folder.path(), view, frame, arrays);
    }
    count_particles(state, static_cast<double>(view.F->size()));
    report_files(state, folder);
}

void checkpoint(benchmark::State& state)
{
    const StandardSphere& sphere = made_for<StandardSphere>(state.range(0));
    const std::string text = config::to_toml(sphere.options);
    const ScratchFolder folder;
    for (auto _ : state)
    {
        record::write_checkpoint(folder.path() / "checkpoint.h5",
                                 record::to_checkpoint(sphere.simulation->state(), {}, text));
    }
    count_particles(state, sphere.particles());
    report_files(state, folder);
}

const bool registered = register_by_size({{"cloud_preparation", cloud_preparation, Timing::once_by_hand},
                                          {"whole_step", whole_step},
                                          {"surface_measures", surface_measures},
                                          {"frame_files", frame_files},
                                          {"checkpoint", checkpoint}});

} // namespace
} // namespace corticle::bench
