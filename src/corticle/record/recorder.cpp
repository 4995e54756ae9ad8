// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/recorder.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/stopwatch.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/frames.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/run_warnings.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>

namespace corticle::record
{

namespace
{

double seconds_since(Recorder::Clock::time_point start)
{
    return std::chrono::duration<double>(Recorder::Clock::now() - start).count();
}

/// Wall time that earlier sessions of an interrupted run took, from its summary [s].
double earlier_wall(const std::filesystem::path& folder)
{
    std::ifstream stream(folder / "summary.json");
    const auto summary = nlohmann::json::parse(stream, nullptr, false);
    return summary.is_object() ? summary.value("wall_s", 0.0) : 0.0;
}

} // namespace

Recorder::Recorder(const RunRequest& request, const prepare::PreparationReport& made, ResultFolder& folder,
                   std::string versions, std::shared_ptr<spdlog::logger> log, Clock::time_point start,
                   const metrics::Measuring& measuring)
    : request_(request), made_(made), folder_(folder), versions_(std::move(versions)), log_(std::move(log)),
      start_(start), measuring_(measuring)
{
}

void Recorder::resume(std::int64_t steps)
{
    first_step_ = steps;
    wall_before_ = earlier_wall(request_.out);
}

void Recorder::on_output(const model::OutputView& view)
{
    {
        const Stopwatch watch(output_s_);
        const std::string name = frame_name(view.number);
        folder_.claim(frame_files(name));
        frame_ = make_frame(view, measuring_.arrays(), name);
        write_frame(request_.out, view, frame_, measuring_.arrays());
        write_tables(request_.out, measuring_.rows());
    }
    log_output(view);
}

void Recorder::log_output(const model::OutputView& view)
{
    const metrics::Measures& row = measuring_.rows().back();
    log_->info("t = {:.4f}: step {}, area ratio {:.4f}, sphere index {:.4f}, hull index {:.4f}, J {:.3f} to "
               "{:.3f}, overlap {:.5f}",
               row.t, view.state().steps, row.area_ratio, row.gi_sphere, row.gi_hull, row.J_min, row.J_max,
               row.overlap_area_share);
    for (const RunWarning& warning : run_warnings(row, size_of_run(view.simulation)))
    {
        const bool is_new = warned_of_.insert(warning.kind).second;
        log_->log(is_new ? spdlog::level::warn : spdlog::level::info, warning.text);
    }
}

void Recorder::summarize(const model::Simulation& simulation, const std::string& status, const std::string& reason)
{
    const metrics::Measures last = measuring_.rows().empty() ? metrics::Measures{} : measuring_.rows().back();
    formats::write_text_atomically(request_.out / "summary.json",
                                   summary_json(simulation, made_, request_.options, last,
                                                run_info(status, reason, simulation.state().steps - first_step_)));
    log_->info("{} at t = {:.6g} after {} steps, {:.1f} s", status, simulation.state().t, simulation.state().steps,
               wall_before_ + seconds_since(start_));
}

void Recorder::record_failure(const model::Simulation* simulation, const std::string& reason)
{
    log_->info("failed: {}", reason);
    try
    {
        if (simulation != nullptr)
        {
            summarize(*simulation, "failed", reason);
            return;
        }
        formats::write_text_atomically(request_.out / "summary.json",
                                       summary_without_state_json(run_info("failed", reason, 0)));
    }
    catch (const std::exception&)
    {
        // The disk that made the run fail has no room for the summary either; the error itself is reported.
    }
}

RunInfo Recorder::run_info(const std::string& status, const std::string& reason, std::int64_t steps) const
{
    const double session = seconds_since(start_);
    return {status,   reason, versions_, thread_count(), wall_before_ + session, session, steps, measuring_.seconds(),
            output_s_};
}

} // namespace corticle::record
