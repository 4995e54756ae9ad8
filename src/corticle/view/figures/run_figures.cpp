// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/run_figures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/view/figures/movie.hpp"
#include "corticle/view/run_pictures.hpp"
#include "corticle/view/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace corticle::view
{

namespace
{

namespace fs = std::filesystem;

std::size_t nearest(std::span<const double> places, double wanted)
{
    const auto found = std::ranges::min_element(places, {}, [&](double place) { return std::abs(place - wanted); });
    return static_cast<std::size_t>(found - places.begin());
}

/// Numbers of the output times asked for, ascending; notes where one is not what was asked for.
std::vector<std::size_t> chosen_frames(const FigureRequest& request, const record::RunContents& run,
                                       std::vector<std::string>& notes)
{
    constexpr double same = 1e-6;
    std::vector<double> times;
    std::vector<double> weeks;
    for (const record::FrameFiles& frame : run.frames)
    {
        times.push_back(frame.t);
        weeks.push_back(record::week_at(run.measures, frame.t));
    }
    if (!request.weeks.empty() && std::ranges::any_of(weeks, [](double week) { return std::isnan(week); }))
    {
        throw InputError(
            fmt::format("--week: {} has no weeks; expected a run with time.clock, or --time", run.folder.string()));
    }
    std::vector<std::size_t> chosen;
    const auto add = [&](std::span<const double> places, std::span<const double> wanted, const char* name)
    {
        for (const double at : wanted)
        {
            if (!std::isfinite(at))
            {
                throw InputError(fmt::format("--{}: got {}; expected a number", name, at));
            }
            chosen.push_back(nearest(places, at));
            if (const double got = places[chosen.back()]; std::abs(got - at) > same)
            {
                notes.push_back(fmt::format("{} {:.4g} is shown, the output time nearest to {:.4g}", name, got, at));
            }
        }
    };
    add(times, request.times, "time");
    add(weeks, request.weeks, "week");
    const bool is_alone = request.plots.empty() && request.movie_frames == 0;
    if (chosen.empty() && is_alone)
    {
        chosen.push_back(run.frames.size() - 1);
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// The scale of an array over all shapes, unless it was given.
ColorScale scale_for(const FigureRequest& request, const std::string& array, std::span<const Shape> shapes,
                     std::size_t number)
{
    std::vector<double> all;
    for (const Shape& shape : shapes)
    {
        all.insert(all.end(), shape.scalars[number].begin(), shape.scalars[number].end());
    }
    ColorScale scale = scalar_scale(array, all);
    scale.map = request.map.value_or(scale.map);
    if (!request.range.empty())
    {
        scale.low = request.range[0];
        scale.high = request.range[1];
    }
    return scale;
}

/// A folder of figures into which none of `files` is written without leave.
record::ResultFolder figures_folder(const FigureRequest& request, std::span<const std::string> files)
{
    record::ResultFolder folder(request.out.empty() ? request.run / "figures" : request.out, "figures");
    folder.require_free(files);
    const auto earlier = std::ranges::find_if(files, [&](const std::string& file) { return folder.has_written(file); });
    if (earlier != files.end() && !request.overwrite)
    {
        throw InputError(fmt::format("{}: holds {} of an earlier call; expected another folder, or --overwrite to "
                                     "replace it",
                                     folder.name(), *earlier));
    }
    folder.make();
    folder.claim(files);
    return folder;
}

void check(const FigureRequest& request)
{
    constexpr int narrowest = 300;
    constexpr int widest = 8000;
    if (!request.range.empty() && (request.range.size() != 2 || !std::isfinite(request.range[0]) ||
                                   !std::isfinite(request.range[1]) || !(request.range[0] < request.range[1])))
    {
        throw InputError(
            fmt::format("--range: got {}; expected two numbers, the lower one first", fmt::join(request.range, ",")));
    }
    if (request.width < narrowest || request.width > widest)
    {
        throw InputError(fmt::format("--width: got {}; expected {} to {} pixels", request.width, narrowest, widest));
    }
}

/// Everything that is drawn of a run.
struct Work
{
    std::vector<AnatomicalView> views;
    std::vector<std::string> arrays;
    BodySides sides;
    std::string view_part; ///< of file names: "_left-medial" where one view is drawn
};

Work work_of(const FigureRequest& request)
{
    Work work{{}, request.arrays, body_sides(request.run), {}};
    work.sides.part = request.part.value_or(work.sides.part);
    work.views = request.views.empty() ? usual_views(work.sides.part) : views_named(request.views);
    work.arrays = work.arrays.empty() ? std::vector<std::string>{"sulcal_depth"} : work.arrays;
    work.view_part = work.views.size() == 1 ? fmt::format("_{}", work.views.front().name) : "";
    return work;
}

std::string plot_file(PlotFormat format)
{
    return "measures." + config::names<PlotFormat>()[static_cast<std::size_t>(format)];
}

} // namespace

bool FigureRequest::is_asked() const
{
    return !(views.empty() && arrays.empty() && range.empty() && !map && times.empty() && weeks.empty() && !part &&
             width == usual_figure_width && !is_transparent && plots.empty() && movie_frames == 0 && out.empty());
}

FigureOutcome render_figures(const FigureRequest& request)
{
    check(request);
    FigureOutcome outcome;
    const record::RunContents run = record::read_run(request.run);
    const Work work = work_of(request);
    const std::vector<std::size_t> chosen = chosen_frames(request, run, outcome.notes);
    const auto still = [&](const std::string& array, std::size_t k)
    { return fmt::format("{}{}_{}.png", array, work.view_part, run.frames[k].name()); };
    std::vector<std::string> files;
    for (const std::string& array : work.arrays)
    {
        for (const std::size_t k : chosen)
        {
            files.push_back(still(array, k));
        }
        if (request.movie_frames > 0)
        {
            const std::vector<std::string> more = movie_files(array + work.view_part, request.movie_frames);
            files.insert(files.end(), more.begin(), more.end());
        }
    }
    std::ranges::transform(request.plots, std::back_inserter(files), plot_file);
    const std::vector<Shape> shapes = chosen.empty() ? std::vector<Shape>{} : read_shapes(run, chosen, work.arrays);
    const std::vector<Shape> all =
        request.movie_frames > 0 ? read_shapes(run, every_frame(run), work.arrays) : std::vector<Shape>{};
    const record::ResultFolder folder = figures_folder(request, files);
    const auto look = [&](std::span<const Shape> drawn)
    { return look_at(work.views, work.sides, drawn, request.width, request.is_transparent); };
    for (std::size_t number = 0; number < work.arrays.size(); ++number)
    {
        const std::string& array = work.arrays[number];
        for (std::size_t i = 0; i < shapes.size(); ++i)
        {
            const fs::path file = folder.path() / still(array, chosen[i]);
            render_shape(file, shapes[i], number, scale_for(request, array, shapes, number), look(shapes));
            outcome.files.push_back(file);
        }
        if (!all.empty())
        {
            const MovieOutcome movie =
                render_movie(folder.path(), {array + work.view_part, all, number,
                                             scale_for(request, array, all, number), look(all), request.movie_frames});
            outcome.files.insert(outcome.files.end(), movie.files.begin(), movie.files.end());
            if (!movie.note.empty())
            {
                outcome.notes.push_back(movie.note);
            }
        }
    }
    for (const PlotFormat format : request.plots)
    {
        render_measures(folder.path() / plot_file(format), run.measures);
        outcome.files.push_back(folder.path() / plot_file(format));
    }
    return outcome;
}

} // namespace corticle::view
