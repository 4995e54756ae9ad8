// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/run_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/version.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/body_file.hpp"
#include "corticle/record/checkpointer.hpp"
#include "corticle/record/progress.hpp"
#include "corticle/record/recorder.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/support_table.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/view/picture_observer.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <future>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;

/// Hands the lines of a log to a function.
class LineSink final : public spdlog::sinks::base_sink<std::mutex>
{
  public:
    explicit LineSink(std::function<void(const std::string&)> take) : take_(std::move(take)) {}

  private:
    void sink_it_(const spdlog::details::log_msg& line) override { take_(fmt::to_string(line.payload)); }
    void flush_() override {}

    std::function<void(const std::string&)> take_;
};

/// run.log gets everything; who runs the case hears of warnings.
std::shared_ptr<spdlog::logger> make_log(const fs::path& folder, const RunHost& host)
{
    auto log = std::make_shared<spdlog::logger>(
        "run", std::make_shared<spdlog::sinks::basic_file_sink_mt>((folder / "run.log").string()));
    if (host.warn)
    {
        log->sinks().push_back(std::make_shared<LineSink>(host.warn));
        log->sinks().back()->set_level(spdlog::level::warn);
    }
    log->flush_on(spdlog::level::info);
    return log;
}

/// What is ready before the run folder is touched.
struct Start
{
    prepare::Preparation made;
    std::optional<record::Restored> restored;
    std::string earlier_versions; ///< of the program, that the checkpoint was made by
    bool draws = false;
    std::string no_pictures; ///< why pictures that were asked for are not drawn
};

Start prepare_start(const record::RunRequest& request, bool draws, std::optional<record::Checkpoint> checkpoint)
{
    Start start;
    start.draws =
        draws && request.options.output.pictures == config::PictureRule::on && view::can_render(start.no_pictures);
    start.made = request.body.empty() ? prepare::arrange_body(request.options)
                                      : record::read_body(request.body, request.options);
    // The renderer gets ready while the body is connected.
    std::future<void> renderer = start.draws ? view::start_renderer() : std::future<void>{};
    prepare::connect_body(request.options, start.made);
    if (start.draws)
    {
        renderer.get();
    }
    if (checkpoint)
    {
        start.earlier_versions = checkpoint->program_version;
        start.restored = record::from_checkpoint(*checkpoint, start.made.model.cloud.positions.size(),
                                                 (request.out / "checkpoint.h5").string());
    }
    return start;
}

/// The folder of a run that begins or goes on, without anything of a run that is replaced.
void open_folder(record::ResultFolder& folder, const record::RunRequest& request, const std::string& case_text,
                 bool goes_on)
{
    folder.make();
    record::require_usable_folder(folder, request); // again: the body may have taken a while
    if (goes_on)
    {
        folder.remove_leftovers();
    }
    else
    {
        folder.remove_written();
    }
    folder.claim(record::run_files());
    if (!request.options.supports.empty())
    {
        const std::vector<std::string> table{record::support_table_name};
        folder.claim(table);
    }
    formats::write_text_atomically(folder.path() / "case.toml", case_text);
}

std::vector<double> output_times_of(std::span<const metrics::Measures> rows)
{
    std::vector<double> times;
    times.reserve(rows.size());
    for (const metrics::Measures& row : rows)
    {
        times.push_back(row.t);
    }
    return times;
}

std::vector<std::string_view> names_of(std::span<const std::unique_ptr<mechanics::ForceTerm>> terms)
{
    std::vector<std::string_view> names;
    for (const auto& term : terms)
    {
        names.push_back(term->name());
    }
    return names;
}

void log_body(spdlog::logger& log, const prepare::Preparation& made)
{
    const model::Model& model = made.model;
    const std::string nodes =
        fmt::format("{} {}, {} of them on the surface, spacing {:.4g} mm", model.cloud.positions.size(),
                    model.fem ? "nodes" : "particles", model.cloud.surface_particles.size(), model.cloud.spacing);
    if (model.fem)
    {
        log.info("{} tets, {}", model.fem->elements.tets.size(), nodes);
    }
    else
    {
        log.info("{}, {:.1f} neighbours, {} pairs dropped because they do not see each other", nodes,
                 made.report.neighbors_mean, made.report.visibility.dropped_pairs);
    }
    for (const std::string& note : made.report.notes)
    {
        log.info(note);
    }
    if (made.report.input_vertices > 0)
    {
        log.info("remeshed {} vertices: area {:+.3f} %, volume {:+.3f} %, at most {:.3g} mm from the input",
                 made.report.input_vertices, 100.0 * made.report.remesh.area_change,
                 100.0 * made.report.remesh.volume_change, made.report.remesh.largest_distance_mm);
    }
    for (const std::string& warning : made.report.warnings)
    {
        log.warn(warning);
    }
}

void log_start(spdlog::logger& log, const record::RunRequest& request, const Start& start, const std::string& versions)
{
    log.info("corticle {}, {} threads", program_version(), thread_count());
    for (const auto& [key, checksum] : request.options.inputs)
    {
        log.info("{}: SHA-256 {}", key, checksum);
    }
    log_body(log, start.made);
    if (start.restored && versions != start.earlier_versions)
    {
        log.warn("the checkpoint was written by version {}, this is {}: the run goes on, but not to the same bits as "
                 "with one version",
                 start.earlier_versions, program_version());
    }
    if (!start.no_pictures.empty())
    {
        log.warn("no pictures: {}", start.no_pictures);
    }
    for (const std::string& warning : start.restored ? config::dropped_outputs(request.options, start.restored->state.t,
                                                                               output_times_of(start.restored->rows))
                                                     : config::case_warnings(request.options))
    {
        log.warn(warning);
    }
}

/// Output times that are not recorded yet.
std::vector<double> times_left(const config::Options& options, std::span<const metrics::Measures> recorded)
{
    std::vector<double> times = record::output_times(options);
    std::erase_if(times, [&](double t) { return !recorded.empty() && recorded.back().t >= t; });
    return times;
}

/// A run as its folder shows it: who looks at it.
struct Observers
{
    Observers(const record::RunRequest& request, const Start& start, record::ResultFolder& folder,
              const std::string& versions, const std::shared_ptr<spdlog::logger>& log,
              record::Recorder::Clock::time_point began)
        : measuring(start.restored ? start.restored->rows : std::vector<metrics::Measures>{}),
          recorder(request, start.made.report, folder, versions, log, began, measuring),
          supports(request.out, start.restored ? start.restored->state.t : -1.0),
          pictures(folder, record::picture_flags(request.options, record::output_times(request.options)), measuring,
                   recorder),
          checkpointer(request.out, config::to_toml(request.options), versions,
                       request.options.output.checkpoint_minutes, measuring, recorder.output_seconds()),
          draws(start.draws)
    {
    }

    model::RunStatus watch(model::Simulation& simulation, const record::RunRequest& request, const RunHost& host)
    {
        record::Progress progress(simulation, request.options.time.end, request.quiet);
        std::vector<model::Observer*> all{&progress, &measuring, &recorder, &supports};
        if (draws)
        {
            all.push_back(&pictures);
        }
        all.push_back(&checkpointer);
        all.insert(all.end(), host.observers.begin(), host.observers.end());
        return model::fold(simulation, times_left(request.options, measuring.rows()), measuring.rows().size(), all,
                           host.stop);
    }

    metrics::Measuring measuring;
    record::Recorder recorder;
    record::SupportTable supports;
    view::PictureObserver pictures;
    record::Checkpointer checkpointer;
    bool draws;
};

/// From the start, or from where it was left, to the end or an interruption. What fails is recorded.
model::RunStatus record_run(const record::RunRequest& request, const RunHost& host, Start& start, Observers& observers,
                            spdlog::logger& log)
{
    std::optional<model::Simulation> simulation;
    const auto fail = [&](const std::string& reason)
    { observers.recorder.record_failure(simulation ? &*simulation : nullptr, reason); };
    model::RunStatus status{};
    try
    {
        simulation.emplace(std::make_shared<const model::Model>(std::move(start.made.model)), request.options);
        log.info("forces: {}", fmt::join(names_of(simulation->terms()), ", "));
        if (start.restored)
        {
            log.info("resumed at t = {:.6g}, step {}", start.restored->state.t, start.restored->state.steps);
            observers.recorder.resume(start.restored->state.steps);
            simulation->restore(std::move(start.restored->state));
        }
        status = observers.watch(*simulation, request, host);
    }
    catch (const std::bad_alloc&)
    {
        fail("out of memory");
        throw;
    }
    catch (const std::exception& error)
    {
        fail(error.what());
        throw;
    }
    observers.recorder.summarize(*simulation, status == model::RunStatus::completed ? "completed" : "interrupted");
    return status;
}

} // namespace

model::RunStatus simulate(const record::RunRequest& request, const RunHost& host)
{
    const record::Recorder::Clock::time_point began = record::Recorder::Clock::now();
    set_thread_count(request.threads);
    const std::string case_text = config::to_toml(request.options);
    record::ResultFolder folder(request.out, "run");
    record::require_usable_folder(folder, request);
    Start start = prepare_start(request, host.draws, record::find_checkpoint(request, case_text));
    const std::string versions = record::versions_after(start.earlier_versions);

    host.opened();
    open_folder(folder, request, case_text, start.restored.has_value());
    const auto log = make_log(request.out, host);
    log_start(*log, request, start, versions);
    Observers observers(request, start, folder, versions, log, began);
    return record_run(request, host, start, observers, *log);
}

model::RunStatus simulate(const record::RunRequest& request)
{
    std::optional<InterruptionGuard> guard; // until then a signal ends the process at once
    RunHost host;
    host.stop = &InterruptionGuard::requested;
    host.opened = [&] { guard.emplace(); };
    if (!request.quiet)
    {
        host.warn = [](const std::string& line) { std::fprintf(stderr, "corticle: warning: %s\n", line.c_str()); };
    }
    return simulate(request, host);
}

} // namespace corticle::study
