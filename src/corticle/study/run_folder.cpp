// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/run_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/version.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/model/scatter.hpp"
#include "corticle/model/terms.hpp"
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

void log_start(spdlog::logger& log, const record::RunRequest& request, const Start& start, const std::string& versions,
               const Communicator& ranks)
{
    log.info("corticle {}, {}{} threads", program_version(),
             ranks.size() > 1 ? fmt::format("{} ranks of ", ranks.size()) : "", thread_count());
    if (ranks.size() > 1 && !model::shares_work(request.options))
    {
        log.warn("the method of this case does not share its work: every rank does all of it, and more than one gain "
                 "nothing");
    }
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
        std::vector<double> times = times_left(request.options, measuring.rows());
        host.ranks->broadcast(times);
        return model::fold(simulation, times, measuring.rows().size(), all, host.stop);
    }

    metrics::Measuring measuring;
    record::Recorder recorder;
    record::SupportTable supports;
    view::PictureObserver pictures;
    record::Checkpointer checkpointer;
    bool draws;
};

/// The simulation where it starts, or goes on: rank 0 has body and state, and hands them to the others.
model::Simulation start_simulation(const record::RunRequest& request, const Communicator& ranks, Start& start)
{
    const Share share = model::scatter(start.made.model, request.options, ranks);
    model::Simulation simulation(std::make_shared<const model::Model>(std::move(start.made.model)), request.options,
                                 share);
    bool goes_on = start.restored.has_value();
    ranks.broadcast(std::span(&goes_on, 1));
    if (goes_on)
    {
        model::State state = ranks.is_root() ? std::move(start.restored->state) : model::State();
        model::broadcast(state, ranks);
        simulation.restore(std::move(state));
    }
    return simulation;
}

/// A run whose folder is open, and what rank 0 has ready before it starts.
struct OpenRun
{
    OpenRun(const record::RunRequest& request, const RunHost& host)
        : case_text(config::to_toml(request.options)), folder(request.out, "run")
    {
        record::require_usable_folder(folder, request);
        start = prepare_start(request, host.draws, record::find_checkpoint(request, case_text));
        const std::string versions = record::versions_after(start.earlier_versions);
        host.opened();
        open_folder(folder, request, case_text, start.restored.has_value());
        log = make_log(request.out, host);
        log_start(*log, request, start, versions, *host.ranks);
        observers.emplace(request, start, folder, versions, log, began);
    }

    record::Recorder::Clock::time_point began = record::Recorder::Clock::now();
    std::string case_text;
    record::ResultFolder folder;
    Start start;
    std::shared_ptr<spdlog::logger> log;
    std::optional<Observers> observers;
};

/// From the start, or from where it was left, to the end or an interruption. What fails is recorded.
model::RunStatus record_run(const record::RunRequest& request, const RunHost& host, OpenRun& run)
{
    std::optional<model::Simulation> simulation;
    const auto fail = [&](const std::string& reason)
    { run.observers->recorder.record_failure(simulation ? &*simulation : nullptr, reason); };
    model::RunStatus status{};
    try
    {
        simulation.emplace(start_simulation(request, *host.ranks, run.start));
        run.log->info("forces: {}", fmt::join(names_of(simulation->terms()), ", "));
        if (run.start.restored)
        {
            run.log->info("resumed at t = {:.6g}, step {}", simulation->state().t, simulation->state().steps);
            run.observers->recorder.resume(simulation->state().steps);
        }
        status = run.observers->watch(*simulation, request, host);
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
    run.observers->recorder.summarize(*simulation, status == model::RunStatus::completed ? "completed" : "interrupted");
    return status;
}

/// The part of the other ranks, which read and write nothing.
model::RunStatus follow(const record::RunRequest& request, const RunHost& host)
{
    host.opened();
    Start nothing;
    model::Simulation simulation = start_simulation(request, *host.ranks, nothing);
    std::vector<double> times;
    host.ranks->broadcast(times);
    return model::fold(simulation, times, 0, {}, host.stop);
}

} // namespace

model::RunStatus simulate(const record::RunRequest& request, const RunHost& host)
{
    set_thread_count(request.threads);
    std::optional<OpenRun> run;
    at_root(*host.ranks, [&] { run.emplace(request, host); });
    return run ? record_run(request, host, *run) : follow(request, host);
}

model::RunStatus simulate(const record::RunRequest& request, const Communicator& ranks)
{
    std::optional<InterruptionGuard> guard; // until then a signal ends the process at once
    RunHost host;
    host.ranks = &ranks;
    host.stop = &InterruptionGuard::requested;
    host.opened = [&] { guard.emplace(); };
    if (!request.quiet)
    {
        host.warn = [](const std::string& line) { std::fprintf(stderr, "corticle: warning: %s\n", line.c_str()); };
    }
    return simulate(request, host);
}

} // namespace corticle::study
