// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/recorder.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/stopwatch.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/frames.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/run_warnings.hpp"
#include "corticle/view/run_pictures.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>

namespace corticle
{

namespace
{

double seconds_since(Recorder::Clock::time_point start)
{
    return std::chrono::duration<double>(Recorder::Clock::now() - start).count();
}

/// Wall time that earlier sessions of an interrupted run took, as its summary tells [s].
double earlier_wall(const std::filesystem::path& folder)
{
    std::ifstream stream(folder / "summary.json");
    const auto summary = nlohmann::json::parse(stream, nullptr, false);
    return summary.is_object() ? summary.value("wall_s", 0.0) : 0.0;
}

} // namespace

Recorder::Recorder(const RunRequest& request, const PreparationReport& made, ResultFolder& folder, std::string versions,
                   std::shared_ptr<spdlog::logger> log, Clock::time_point start, bool draws)
    : request_(request), made_(made), folder_(folder), case_text_(to_toml(request.options)),
      versions_(std::move(versions)), log_(std::move(log)), start_(start), saved_at_(start), draws_(draws)
{
}

void Recorder::resume(std::vector<Measures> rows, std::int64_t steps)
{
    rows_ = std::move(rows);
    first_step_ = steps;
    wall_before_ = earlier_wall(request_.out);
}

void Recorder::record(const Simulation& simulation, bool with_pictures)
{
    const PhysicalScale scale = physical_scale(simulation);
    std::vector<Mat3> F;
    SurfaceArrays arrays;
    {
        const Stopwatch watch(measures_s_);
        F = simulation.deformation_gradients();
        arrays = surface_arrays(simulation, F, scale);
        rows_.push_back(measure(simulation, F, arrays, scale));
    }
    write(simulation, std::move(F), scale, arrays, with_pictures);
    save(simulation);
    const Measures& row = rows_.back();
    log_->info("t = {:.4f}: step {}, area ratio {:.4f}, sphere index {:.4f}, hull index {:.4f}, J {:.3f} to "
               "{:.3f}, overlap {:.5f}",
               row.t, simulation.state().steps, row.area_ratio, row.gi_sphere, row.gi_hull, row.J_min, row.J_max,
               row.overlap_area_share);
    for (const RunWarning& warning : run_warnings(row, size_of_run(simulation)))
    {
        const bool is_new = warned_of_.insert(warning.kind).second;
        log_->log(is_new ? spdlog::level::warn : spdlog::level::info, warning.text);
    }
}

void Recorder::save(const Simulation& simulation)
{
    const Stopwatch watch(output_s_);
    // What the checkpoint counts as written must be there after a power cut.
    flush_names(request_.out / "pictures");
    flush_names(request_.out);
    write_checkpoint(request_.out / "checkpoint.h5", to_checkpoint(simulation.state(), rows_, case_text_, versions_));
    saved_at_ = Clock::now();
}

void Recorder::save_if_due(const Simulation& simulation)
{
    if (seconds_since(saved_at_) > 60.0 * request_.options.output.checkpoint_minutes)
    {
        save(simulation);
    }
}

void Recorder::summarize(const Simulation& simulation, const std::string& status, const std::string& reason)
{
    const Measures last = rows_.empty() ? Measures{} : rows_.back();
    write_text_atomically(request_.out / "summary.json",
                          summary_json(simulation, made_, request_.options, last,
                                       run_info(status, reason, simulation.state().steps - first_step_)));
    log_->info("{} at t = {:.6g} after {} steps, {:.1f} s", status, simulation.state().t, simulation.state().steps,
               wall_before_ + seconds_since(start_));
}

void Recorder::record_failure(const std::optional<Simulation>& simulation, const std::string& reason)
{
    log_->info("failed: {}", reason);
    try
    {
        if (simulation)
        {
            summarize(*simulation, "failed", reason);
            return;
        }
        write_text_atomically(request_.out / "summary.json", summary_without_state_json(run_info("failed", reason, 0)));
    }
    catch (const std::exception&)
    {
        // The disk that made the run fail has no room for the summary either; the error itself is reported.
    }
}

void Recorder::draw_measures()
{
    if (draws_)
    {
        const Stopwatch watch(output_s_);
        folder_.claim(std::array{std::string(measures_picture)});
        render_measures(request_.out, rows_);
    }
}

RunInfo Recorder::run_info(const std::string& status, const std::string& reason, std::int64_t steps) const
{
    const double session = seconds_since(start_);
    return {status, reason, versions_, thread_count(), wall_before_ + session, session, steps, measures_s_, output_s_};
}

void Recorder::write(const Simulation& simulation, std::vector<Mat3> F, const PhysicalScale& scale,
                     const SurfaceArrays& arrays, bool with_pictures)
{
    const Stopwatch watch(output_s_);
    const std::string name = frame_name(rows_.size() - 1);
    folder_.claim(frame_files(name, with_pictures && draws_));
    Frame frame = make_frame(simulation, std::move(F), scale, name);
    frame.sulcal_depth = arrays.folds.sulcal_depth;
    frame.mean_curvature = arrays.folds.curvature.mean;
    write_frame(request_.out, simulation, frame, arrays);
    write_tables(request_.out, rows_);
    if (with_pictures && draws_)
    {
        render_frame(request_.out, frame);
    }
}

} // namespace corticle
