// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/parallel.hpp"

#include "corticle/base/stopwatch.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/prepare/prepare.hpp"
#include "corticle/study/run_folder.hpp"

#include <fmt/format.h>

namespace corticle::study
{

namespace
{

constexpr int timed_steps = 10;
// A fold's steps over those its first step size would give, at constant loading: growth and creases shorten them.
constexpr double steps_over_first = 4.0;
constexpr double contact_surcharge = 1.2; ///< time of a step with folds that touch, over one without

} // namespace

Plan plan(const config::Options& options, int threads)
{
    set_thread_count(threads);
    prepare::Preparation made = prepare::prepare_body(options);
    const auto shared = std::make_shared<const model::Model>(std::move(made.model));
    const model::Model& model = *shared;
    Plan result;
    result.particles = std::ssize(model.cloud.positions);
    result.surface_vertices = std::ssize(model.cloud.surface_particles);
    result.spacing_mm = model.cloud.spacing;
    result.neighbors_mean = made.report.neighbors_mean;
    result.memory_mb =
        prepare::estimated_memory(options.method, static_cast<double>(result.particles), result.neighbors_mean) / 1e6;
    std::string notes;
    for (const std::string& note : made.report.notes)
    {
        notes += note + "\n";
    }
    for (const std::string& warning : made.report.warnings)
    {
        notes += "warning: " + warning + "\n";
    }

    model::Simulation simulation(shared, options);
    const dynamics::DynamicsOptions& dynamics = options.dynamics;
    const double longer = dynamics.time_step > 0.0 ? 1.0 : steps_over_first * dynamics::quickened_steps(dynamics);
    result.steps = longer * (options.time.end - options.time.start) / simulation.step_size();
    double timed_s = 0.0;
    {
        const Stopwatch watch(timed_s);
        for (int k = 0; k < timed_steps; ++k)
        {
            simulation.step(options.time.end);
        }
    }
    result.seconds = contact_surcharge * timed_s / timed_steps * result.steps;
    const std::string links = model.fem ? fmt::format("elements    {}", model.fem->elements.tets.size())
                                        : fmt::format("neighbours  {:.1f}", result.neighbors_mean);
    result.text = fmt::format("{}particles   {} ({} on the surface)\nspacing     {:.4g} mm\n{}\nsteps  "
                              "     about {:.0f}\nmemory      about "
                              "{:.0f} MB\ntime        about {:.0f} s on {} threads\n",
                              notes, result.particles, result.surface_vertices, result.spacing_mm, links, result.steps,
                              result.memory_mb, result.seconds, thread_count());
    return result;
}

} // namespace corticle::study
