// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/real_comparison.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/metrics/comparison.hpp"
#include "corticle/study/comparison/real_surface.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;

/// FILE@WEEK or FILE@t=T, taken apart.
struct Place
{
    fs::path file;
    bool is_week = true;
    double value = 0.0;
};

Place parse_place(const std::string& text)
{
    const std::size_t at = text.rfind('@');
    const auto refuse = [&](const std::string& what)
    {
        throw InputError(fmt::format(
            "{}: {}; expected a run folder, or a surface or label volume with its week, FILE@WEEK (or FILE@t=T)", text,
            what));
    };
    if (at == std::string::npos || at == 0)
    {
        refuse(at == 0 ? "no file before the @" : "no run folder, and no @");
    }
    Place place{text.substr(0, at), true, 0.0};
    std::string_view number = std::string_view(text).substr(at + 1);
    if (number.starts_with("t="))
    {
        place.is_week = false;
        number.remove_prefix(2);
    }
    if (!formats::to_number(number, place.value) || !std::isfinite(place.value))
    {
        refuse(fmt::format("\"{}\" is not a number", number));
    }
    return place;
}

/// Growth time to place on the axis.
struct Axis
{
    const formats::NumberColumn* t;
    const formats::NumberColumn* week; ///< null: the run has no clock, and the axis is t

    double place_of_t(double growth_time) const
    {
        return week == nullptr ? growth_time : metrics::interpolate(t->values, week->values, growth_time);
    }
};

Axis axis_of(const record::RunContents& run)
{
    Axis axis{run.measures.find("t"), run.measures.find("week")};
    if (axis.week != nullptr && std::ranges::all_of(axis.week->values, [](double week) { return std::isnan(week); }))
    {
        axis.week = nullptr; // a run without a clock
    }
    if (axis.week != nullptr)
    {
        const std::vector<double>& weeks = axis.week->values;
        if (std::adjacent_find(weeks.begin(), weeks.end(), [](double a, double b) { return !(a < b); }) != weeks.end())
        {
            throw InputError(fmt::format("{}: week does not ascend from row to row; expected weeks of a clock",
                                         (run.folder / "measures.csv").string()));
        }
    }
    return axis;
}

RealSurface measure_real(const std::string& name, const Axis& axis, const RealSurfaceOptions& options)
{
    const Place place = parse_place(name);
    if (place.is_week && axis.week == nullptr)
    {
        throw InputError(
            fmt::format("{}: the run has no weeks (no clock); expected FILE@t=T with a growth time", name));
    }
    RealSurfaceReading reading = read_real_surface(place.file, options);
    std::vector<metrics::SurfaceRow> rows = surface_rows(reading);
    return {name,
            place.is_week ? place.value : axis.place_of_t(place.value),
            std::move(reading.surface),
            std::move(rows),
            std::nullopt,
            std::move(reading.notes),
            std::move(reading.warnings)};
}

void require_common_places(const RealComparison& comparison)
{
    const auto is_reached = [&](const RealSurface& real)
    { return real.place >= comparison.places.front() && real.place <= comparison.places.back(); };
    if (std::none_of(comparison.reals.begin(), comparison.reals.end(), is_reached))
    {
        std::vector<std::string> names;
        for (const RealSurface& real : comparison.reals)
        {
            names.push_back(real.name);
        }
        throw InputError(fmt::format("no common times: {} covers {} = {:.6g} to {:.6g}; got {}",
                                     comparison.run_folder.string(), comparison.axis, comparison.places.front(),
                                     comparison.places.back(), fmt::join(names, ", ")));
    }
}

TriangleMesh surface_of_frame(const record::FrameFiles& frame)
{
    TriangleMesh surface = formats::read_surface_vtp(frame.surface).mesh;
    if (surface.triangles.empty() || !std::all_of(surface.vertices.begin(), surface.vertices.end(), is_finite))
    {
        throw InputError(fmt::format("{}: not a surface with finite coordinates", frame.surface.string()));
    }
    return surface;
}

metrics::SurfaceView view_of(const TriangleMesh& mesh)
{
    return {mesh.vertices, mesh.triangles};
}

/// Patterns of folds at the outputs nearest to the real surfaces that the run reaches.
void set_patterns(const std::vector<TriangleMesh>& surfaces, RealComparison& comparison)
{
    for (RealSurface& real : comparison.reals)
    {
        if (real.place < comparison.places.front() || real.place > comparison.places.back())
        {
            continue;
        }
        const auto nearest =
            std::ranges::min_element(comparison.places, {}, [&](double place) { return std::abs(place - real.place); });
        const auto k = static_cast<std::size_t>(nearest - comparison.places.begin());
        real.pattern = {metrics::fold_pattern(view_of(surfaces.front()), view_of(surfaces[k]), view_of(real.surface)),
                        *nearest};
    }
}

} // namespace

double RealComparison::run_value(std::size_t row, const RealSurface& real) const
{
    std::vector<double> values;
    for (const std::vector<metrics::SurfaceRow>& rows : run_rows)
    {
        values.push_back(rows[row].value);
    }
    return metrics::interpolate(places, values, real.place);
}

std::vector<std::string> RealComparison::warnings() const
{
    std::vector<std::string> lines;
    for (const RealSurface& real : reals)
    {
        for (const std::string& warning : real.warnings)
        {
            lines.push_back(fmt::format("{}: {}", real.name, warning));
        }
    }
    return lines;
}

RealComparison compare_with_real(const ComparisonRequest& request)
{
    const record::RunContents run = record::read_run(request.run);
    const Axis axis = axis_of(run);
    RealComparison result;
    result.run_name = fs::absolute(request.run / ".").lexically_normal().parent_path().filename().string();
    result.run_folder = request.run;
    result.reading = request.real;
    result.axis = axis.week == nullptr ? "t" : "week";
    for (const std::string& name : request.others)
    {
        result.reals.push_back(measure_real(name, axis, request.real));
    }
    std::vector<record::FrameFiles> frames;
    for (const record::FrameFiles& frame : run.frames)
    {
        const double place = axis.place_of_t(frame.t);
        if (std::isfinite(place)) // the table may lag behind the frames while the run goes on
        {
            result.places.push_back(place);
            frames.push_back(frame);
        }
    }
    if (frames.empty())
    {
        throw InputError(
            fmt::format("{}: measures.csv covers none of the frames; expected a row for each", request.run.string()));
    }
    require_common_places(result);
    std::vector<TriangleMesh> surfaces;
    for (const record::FrameFiles& frame : frames)
    {
        surfaces.push_back(surface_of_frame(frame));
        result.run_rows.push_back(metrics::surface_rows(surfaces.back().vertices, surfaces.back().triangles));
    }
    if (request.patterns)
    {
        set_patterns(surfaces, result);
    }
    return result;
}

} // namespace corticle::study
