// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"
#include "command_pages.hpp"
#include "thread_limits.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>

// This file and show_verbs.cpp alone know the command line.

int corticle::complain(std::string message, int status)
{
    for (char& c : message)
    {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    message.erase(message.find_last_not_of(' ') + 1);
    std::fprintf(stderr, "corticle: error: %s\n", message.c_str());
    return status;
}

namespace
{

using namespace corticle;

void add_overrides(CLI::App& verb, std::vector<std::string>& overrides)
{
    verb.add_option("--set", overrides, "Change a key of the case; may be repeated")
        ->type_name("SECTION.KEY=VALUE")
        ->type_size(1)
        ->allow_extra_args(false);
}

void add_threads(CLI::App& verb, int& threads)
{
    verb.add_option("--threads", threads, "Number of threads (default: all cores)")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads))
        ->check([](const std::string& count) { return thread_shortage(std::atoi(count.c_str())); });
}

void add_no_report(CLI::App& verb, bool& report)
{
    verb.add_flag_callback(
        "--no-report", [&report] { report = false; }, "Do not write report.html");
}

void add_run(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* verb = app.add_subcommand("run", "Run a case");
    verb->add_option("case", arguments->case_file, "Case to run; - for the standard input")
        ->type_name("CASE.toml")
        ->required();
    verb->add_option("--out", arguments->request.out, "Run folder (default: runs/<name of the case>)")
        ->type_name("DIR");
    verb->add_option("--body", arguments->request.body,
                     "Body made by prepare from the same [geometry] and [map], or its folder")
        ->type_name("BODY");
    add_overrides(*verb, arguments->overrides);
    add_threads(*verb, arguments->request.threads);
    verb->add_flag("--resume", arguments->request.resume, "Continue the run in the folder from its checkpoint");
    verb->add_flag("--overwrite", arguments->request.overwrite, "Remove an earlier run in the folder first");
    verb->add_flag("--quiet", arguments->request.quiet, "Print nothing but errors");
    verb->callback([arguments, &chosen] { chosen = [arguments] { return run_command(*arguments); }; });
}

/// Options of verbs that make many runs.
template <class Request>
void add_many_runs(CLI::App& verb, Request& request)
{
    add_overrides(verb, request.overrides);
    verb.add_option("--jobs", request.jobs, "Runs side by side (default: as many as there are cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--threads-per-run", request.threads_per_run, "Threads of each run (default: to fill the cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_flag("--quiet", request.quiet, "Print nothing but errors");
}

void add_sweep(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<SweepArguments>();
    sweep::SweepRequest* const request = &arguments->request;
    CLI::App* verb = app.add_subcommand("sweep", "Run a case for many values of its keys; goes on where it stopped");
    verb->add_option("sweep", request->file, "Sweep to run")->type_name("SWEEP.toml")->required();
    verb->add_option("--out", request->out, "Folder of the sweep (default: runs/<name of the sweep>)")
        ->type_name("DIR");
    add_many_runs(*verb, *request);
    verb->add_option("--only", request->only, "Make only these runs; may be repeated")
        ->type_name("NUMBER|NAME|SECTION.KEY=VALUE")
        ->type_size(1)
        ->allow_extra_args(false);
    add_choice(*verb, "--engine", request->engine,
               "local: make the runs here; commands: print the command of each; slurm: submit them as an array job, "
               "by [engine] of the sweep")
        ->type_name("ENGINE");
    verb->add_flag("--retry", request->retry, "Go on with runs that failed");
    verb->add_flag("--gather", request->gather, "Make no runs; write tables and pictures of those that are there");
    verb->add_flag("--cases-only", request->cases_only, "Write the case of each run to DIR/cases and make none");
    verb->add_flag("--list", request->list, "Print the runs and how they stand; write nothing");
    add_no_report(*verb, arguments->report);
    verb->callback([arguments, &chosen] { chosen = [arguments] { return sweep_command(*arguments); }; });
}

void add_study(CLI::App& verb, fit::FitRequest& request)
{
    verb.add_option("study", request.file, "What to study; goes on where it stopped")
        ->type_name("STUDY.toml")
        ->required();
    verb.add_option("--out", request.out, "Folder of the study (default: runs/<its name>)")->type_name("DIR");
    verb.add_option("--runs", request.runs, "Folder of its run folders, which studies may share (default: DIR/runs)")
        ->type_name("DIR");
    add_many_runs(verb, request);
}

void add_fit(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<fit::FitRequest>();
    CLI::App* verb = app.add_subcommand("fit", "Find the parameters of a case that explain targets, and how surely");
    add_study(*verb, *request);
    verb->callback([request, &chosen] { chosen = [request] { return fit_command(*request); }; });
}

void add_sensitivity(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<sensitivity::SensitivityRequest>();
    CLI::App* verb = app.add_subcommand("sensitivity", "Which parameters of a case matter for measures of its runs");
    add_study(*verb, *request);
    verb->callback([request, &chosen] { chosen = [request] { return sensitivity_command(*request); }; });
}

void add_regions(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<regions::RegionsRequest>();
    CLI::App* verb = app.add_subcommand("regions", "Find how much each region grows from its areas at a later week");
    verb->add_option("case", request->case_file, "Case with regions and a table of their growth to start from")
        ->type_name("CASE.toml")
        ->required();
    verb->add_option("--areas", request->areas, "Areas to reach: columns label and area_mm2")
        ->type_name("AREAS.csv")
        ->required();
    verb->add_option("--week", request->week, "Week of these areas (default: the end of the case)")->type_name("W");
    verb->add_option("--out", request->out, "Folder of the results (default: runs/<name of the case>_regions)")
        ->type_name("DIR");
    verb->add_option("--rounds", request->rounds, "Runs at most")->capture_default_str()->check(CLI::Range(1, 100));
    verb->add_option("--tolerance", request->tolerance, "Largest relative error of an area to stop at")
        ->capture_default_str()
        ->check(CLI::Range(1e-6, 1.0));
    add_overrides(*verb, request->overrides);
    add_threads(*verb, request->threads);
    verb->add_flag("--quiet", request->quiet, "Print nothing but errors");
    verb->callback([request, &chosen] { chosen = [request] { return regions_command(*request); }; });
}

void add_prepare(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<PrepareArguments>();
    CLI::App* verb =
        app.add_subcommand("prepare", "Make the body of a case, and nothing else: report, files, pictures");
    verb->add_option("case", arguments->case_file, "Case to prepare; - for the standard input")
        ->type_name("CASE.toml")
        ->required();
    verb->add_option("--out", arguments->request.out, "Folder for the body (default: prepared/<name of the case>)")
        ->type_name("DIR");
    add_overrides(*verb, arguments->overrides);
    add_threads(*verb, arguments->request.threads);
    verb->add_flag("--overwrite", arguments->request.overwrite, "Replace an earlier body in the folder");
    verb->add_flag("--compare-thesis", arguments->request.compare_thesis,
                   "Also measure the thesis's own choices beside the exact answer");
    verb->add_flag("--quiet", arguments->quiet, "Print nothing but errors");
    verb->callback([arguments, &chosen] { chosen = [arguments] { return prepare_command(*arguments); }; });
}

void add_new(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<NewArguments>();
    CLI::App* verb = app.add_subcommand("new", "Write a commented starter case, or a phantom brain; never overwrites");
    verb->add_option("case", arguments->what,
                     "Case to write; brain: the phantom, as brain.nii.gz, its lobes and brain.toml")
        ->type_name("NAME.toml|brain")
        ->required();
    add_choice(*verb, "--shape", arguments->shape, "sphere, ellipsoid or file")->type_name("SHAPE");
    verb->callback([arguments, &chosen] { chosen = [arguments] { return new_command(*arguments); }; });
}

void add_check(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* verb = app.add_subcommand("check", "Print the resolved case and what a run of it will take");
    verb->add_option("case", arguments->case_file, "Case to check; - for the standard input")
        ->type_name("CASE.toml")
        ->required();
    add_overrides(*verb, arguments->overrides);
    add_threads(*verb, arguments->threads);
    verb->callback([arguments, &chosen] { chosen = [arguments] { return check_command(*arguments); }; });
}

void add_schema(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<SchemaArguments>();
    CLI::App* verb = app.add_subcommand("schema", "Print every key of a case: type, default, unit, range, meaning");
    verb->add_flag("--markdown", arguments->markdown, "As Markdown");
    verb->add_flag("--measures", arguments->measures, "The measures of a run instead: key, unit, meaning, as Markdown");
    auto page = std::make_shared<CommandPage>();
    const CLI::Option* of_command = add_choice(*verb, "--of-command", *page,
                                               "The command line instead: man, its manual page, or its completions "
                                               "for bash, zsh or fish")
                                        ->type_name("FORM")
                                        ->default_str("");
    verb->callback(
        [=, &app, &chosen]
        {
            chosen = [=, &app]
            { return of_command->count() > 0 ? command_page_command(app, *page) : schema_command(*arguments); };
        });
}

/// How a real brain is read, for the verbs that measure one.
void add_real_surface(CLI::App& verb, study::RealSurfaceOptions& options)
{
    add_choice(verb, "--unit", options.unit, "Unit of length of surface files: mm, cm or m")->type_name("UNIT");
    add_choice(verb, "--coordinates", options.coordinates,
               "scanner: brought to the scanner's where the file says how; file: as they are")
        ->type_name("WHICH");
    verb.add_option("--labels", options.mask.labels, "Labels of a label volume that are the body (default: all but 0)")
        ->type_name("A,B,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    verb.add_option("--threshold", options.mask.threshold,
                    "Of a map of probabilities: the body is where it is at least this")
        ->type_name("VALUE");
    verb.add_option("--closing-mm", options.mask.closing_mm, "Radius by which the mask of the labels is closed")
        ->capture_default_str()
        ->type_name("MM");
    verb.add_option("--smoothing-mm", options.mask.smoothing_mm, "Standard deviation of the smoothing of the mask")
        ->capture_default_str()
        ->type_name("MM");
}

void add_measure(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<MeasureArguments>();
    CLI::App* verb = app.add_subcommand("measure", "Size, indices and folds of a closed surface or of labels");
    verb->add_option("file", arguments->file, "STL, OBJ, PLY, OFF, VTP, VTK, GIFTI, FreeSurfer, or labels: NIfTI, MGH")
        ->type_name("FILE")
        ->required();
    add_real_surface(*verb, arguments->options);
    add_choice(*verb, "--outer", arguments->outer,
               "Outer surface for sulcal depth and local index: hull, or closed (a ball rolled around the body)")
        ->type_name("SURFACE");
    add_choice(*verb, "--surface", arguments->surface,
               "triangles: as the file has it; delaunay: made from its points alone (particles_*.vtu, a .csv with "
               "x, y, z, or vertices), beside the surface of the run where the file belongs to one")
        ->type_name("HOW");
    verb->add_option("--length-limit", arguments->length_limit_mm,
                     "Largest radius of the ball about a tet (default: 5/3 of the mean distance of points)")
        ->type_name("MM")
        ->check(CLI::PositiveNumber);
    verb->add_option("--out", arguments->out, "Write the surface made from points")->type_name("FILE.vtp");
    verb->add_option("--regions", arguments->regions, "Also the area of each region that this label volume knows")
        ->type_name("FILE.nii.gz");
    verb->add_option("--areas", arguments->areas, "Write these areas as a table: label, area_mm2")
        ->type_name("FILE.csv");
    verb->add_flag("--overwrite", arguments->overwrite, "Replace the file of --out or --areas");
    verb->add_flag("--json", arguments->json, "As JSON");
    verb->callback([arguments, &chosen] { chosen = [arguments] { return measure_command(*arguments); }; });
}

void add_compare(CLI::App& app, Verb& chosen)
{
    auto arguments = std::make_shared<CompareArguments>();
    study::ComparisonRequest& request = arguments->request;
    CLI::App* verb =
        app.add_subcommand("compare", "Compare a run with another run, with many of its body, or with real surfaces");
    verb->add_option("run", request.run, "Run folder")->type_name("RUN")->required();
    verb->add_option("others", request.others,
                     "Other run folders, or real surfaces or labels, each with its week (or FILE@t=T)")
        ->type_name("RUN|FILE@WEEK")
        ->required();
    verb->add_option("--out", request.out, "Folder of the report (default: compare_<A>_<B>)")->type_name("DIR");
    verb->add_flag("--overwrite", request.overwrite, "Replace an earlier report in the folder");
    verb->add_option(
            "--time", request.picture_times,
            "Growth time of the pictures of two runs; may be repeated (default: half and end); of more runs, when "
            "to compare them (default: end)")
        ->type_name("T")
        ->type_size(1)
        ->allow_extra_args(false);
    add_real_surface(*verb, request.real);
    verb->add_flag("--json", arguments->json, "Print the comparison as JSON");
    add_no_report(*verb, arguments->report);
    verb->callback([arguments, &chosen] { chosen = [arguments] { return compare_command(*arguments); }; });
}

int dispatch(int argc, char** argv)
{
    CLI::App app("Corticle: meshless simulation of cortical folding", "corticle");
    app.set_version_flag("--version", fmt::format("corticle {}", program_version()));
    app.require_subcommand(1);
    app.footer("Exit status: 0 done, 2 bad usage or input, 3 the run failed, 130 interrupted.");
    Verb chosen;
    for (auto add : {add_run, add_sweep, add_fit, add_sensitivity, add_regions, add_prepare, add_new, add_check,
                     add_schema, add_measure, add_compare, add_render, add_report, add_export})
    {
        add(app, chosen);
    }
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        if (error.get_exit_code() == 0)
        {
            return app.exit(error); // --help, --version
        }
        const auto named = [&](const CLI::App* verb) { return verb->get_name() == argv[1]; };
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty())
        {
            return complain("unknown verb \"" + std::string(argv[1]) +
                                "\", expected run, sweep, fit, sensitivity, regions, prepare, new, check, schema, "
                                "measure, compare, render, "
                                "report or export",
                            exit_status::bad_input);
        }
        return complain(std::string(error.what()) + " (`corticle --help` shows the usage)", exit_status::bad_input);
    }
    return chosen();
}

/// Output that could not be written must not pass for success.
int flushed(int status)
{
    std::cout.flush();
    if (status == exit_status::done && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout))
    {
        return complain("cannot write to the standard output", exit_status::failed);
    }
    return status;
}

/// Threads that wait for each other sleep after a short spin: on a machine that others use too, spinning made
/// runs ten times slower. OpenMP reads its environment before main, so the command starts itself once more.
void sleep_at_barriers(char** argv)
{
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error && std::getenv("OMP_WAIT_POLICY") == nullptr && std::getenv("GOMP_SPINCOUNT") == nullptr)
    {
        setenv("GOMP_SPINCOUNT", "20000", 0);
        execv(self.c_str(), argv); // where it fails, the command just goes on
    }
}

} // namespace

int main(int argc, char** argv)
{
    sleep_at_barriers(argv);
    try
    {
        require_thread_environment();
        return flushed(dispatch(argc, argv));
    }
    catch (const InputError& error)
    {
        return complain(error.what(), exit_status::bad_input);
    }
    catch (const std::bad_alloc&)
    {
        return complain("out of memory", exit_status::failed);
    }
    catch (const std::exception& error)
    {
        return complain(error.what(), exit_status::failed);
    }
}
