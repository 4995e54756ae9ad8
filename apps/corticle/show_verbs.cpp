// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <memory>

namespace corticle
{

namespace
{

/// The place of a name that CLI11 has found among the names.
template <class Names>
std::size_t place_of(const Names& names, const std::string& name)
{
    return static_cast<std::size_t>(std::ranges::find(names, name) - std::begin(names));
}

view::ColorMap color_map_of(const std::string& name)
{
    return static_cast<view::ColorMap>(place_of(view::color_map_names, name));
}

imaging::Hemisphere hemisphere_of(const std::string& name)
{
    return static_cast<imaging::Hemisphere>(place_of(imaging::hemisphere_names, name));
}

std::vector<view::PlotFormat> plot_formats_of(const std::vector<std::string>& names)
{
    std::vector<view::PlotFormat> formats;
    for (const std::string& name : names)
    {
        formats.push_back(static_cast<view::PlotFormat>(place_of(config::names<view::PlotFormat>(), name)));
    }
    return formats;
}

/// An option that may be repeated, or hold several values with commas between.
template <class T>
void add_list(CLI::App& verb, const std::string& name, std::vector<T>& values, const std::string& meaning,
              const std::string& form)
{
    verb.add_option(name, values, meaning)->type_name(form)->delimiter(',')->allow_extra_args(false);
}

} // namespace

void add_render(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<view::FigureRequest>();
    CLI::App* verb = app.add_subcommand("render", "Draw the pictures of a run again, or pictures of it for papers");
    verb->add_option("run", request->run, "Run folder; alone: its usual pictures again")->type_name("RUN")->required();
    add_list(*verb, "--view", request->views,
             "left- or right- with lateral, medial, dorsal or ventral; dorsal, ventral, left, right, anterior, "
             "posterior, oblique (default: the first eight, on one page)",
             "NAME,...");
    add_list(*verb, "--array", request->arrays, "Arrays of the surface files (default: sulcal_depth)", "NAME,...");
    verb->add_option("--range", request->range, "Range of the colours (default: most values); --range=-1,1")
        ->type_name("LOW,HIGH")
        ->delimiter(',')
        ->allow_extra_args(false);
    verb->add_option_function<std::string>(
            "--map", [request](const std::string& name) { request->map = color_map_of(name); },
            "Colour map (default: that of the array)")
        ->type_name("MAP")
        ->check(CLI::IsMember(std::vector<std::string>(view::color_map_names.begin(), view::color_map_names.end())));
    add_list(*verb, "--time", request->times, "Growth time; the nearest output time is drawn (default: the last)",
             "T,...");
    add_list(*verb, "--week", request->weeks, "Gestational week; the nearest output time is drawn", "W,...");
    verb->add_option_function<std::string>(
            "--hemisphere", [request](const std::string& name) { request->part = hemisphere_of(name); },
            "Which hemisphere the body is: both, left or right (default: by the case)")
        ->type_name("WHICH")
        ->check(CLI::IsMember(
            std::vector<std::string>(imaging::hemisphere_names.begin(), imaging::hemisphere_names.end())));
    verb->add_option("--width", request->width, "Width of a picture in pixels; its height follows")
        ->capture_default_str()
        ->type_name("PX");
    verb->add_flag("--transparent", request->is_transparent, "Nothing behind the body, instead of white");
    verb->add_option_function<std::vector<std::string>>(
            "--plots", [request](const std::vector<std::string>& names) { request->plots = plot_formats_of(names); },
            "Plot the measures: svg, pdf or png")
        ->type_name("FORMAT,...")
        ->delimiter(',')
        ->check(CLI::IsMember(config::names<view::PlotFormat>()));
    verb->add_flag_callback(
        "--movie", [request] { request->movie_frames = std::max(request->movie_frames, view::usual_movie_frames); },
        "PNGs from the first to the last output time, and an MP4 where ffmpeg is; 4 s");
    verb->add_option("--movie-frames", request->movie_frames, "The same with this number of PNGs; 24 a second")
        ->type_name("N")
        ->check(CLI::Range(1, 9999));
    verb->add_option("--out", request->out, "Folder to write to (default: RUN/figures)")->type_name("DIR");
    verb->add_flag("--overwrite", request->overwrite, "Replace files of earlier calls in the folder");
    verb->callback([request, &chosen] { chosen = [request] { return render_command(*request); }; });
}

void add_report(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<report::ReportRequest>();
    CLI::App* verb = app.add_subcommand("report", "Write report.html: one page for any browser, offline");
    verb->add_option("folder", request->folder, "Folder of a run, a comparison or a sweep")
        ->type_name("FOLDER")
        ->required();
    verb->add_option("--max-mb", request->megabytes,
                     "Largest size of the page; output times, then vertices, are left out to keep it")
        ->capture_default_str()
        ->type_name("MB")
        ->check(CLI::Range(2.0, 2000.0));
    verb->callback([request, &chosen] { chosen = [request] { return report_command(*request); }; });
}

void add_export(CLI::App& app, Verb& chosen)
{
    auto request = std::make_shared<study::ExportRequest>();
    CLI::App* verb = app.add_subcommand("export", "Write the deformed surface of a run for other programs");
    verb->add_option("run", request->run, "Run folder")->type_name("RUN")->required();
    add_choice(*verb, "--format", request->format, "gifti, freesurfer, ply or stl")
        ->type_name("FORMAT")
        ->default_str("")
        ->required();
    verb->add_option("--time", request->times, "Growth time; the nearest frame is written (default: the last)")
        ->type_name("T")
        ->type_size(1)
        ->allow_extra_args(false);
    verb->add_option("--out", request->out, "Folder to write to (default: RUN/export)")->type_name("DIR");
    verb->add_flag("--overwrite", request->overwrite, "Replace files of earlier exports in the folder");
    verb->add_option("--structure", request->structure,
                     "GIFTI: part of the brain, CortexLeft, CortexRight, ... (default: by the case)")
        ->type_name("NAME");
    verb->add_flag("--split", request->split,
                   "GIFTI: a file for each hemisphere, cut in the middle across x where they are connected")
        ->excludes("--structure");
    verb->callback([request, &chosen] { chosen = [request] { return export_command(*request); }; });
}

} // namespace corticle
