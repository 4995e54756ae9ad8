// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/run_variation.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/study/comparison/run_comparison.hpp"
#include "corticle/view/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::study
{

namespace
{

constexpr double same_time = 1e-9;
constexpr double same_place = 1e-6; // of the spacing

constexpr const char* share_picture = "sulcal_share.png";
constexpr const char* deviation_picture = "depth_sd.png";

/// The output of a run at growth time t, or null.
const record::FrameFiles* frame_at(const record::RunContents& run, double t)
{
    const auto found = std::ranges::find_if(run.frames, [t](const record::FrameFiles& frame)
                                            { return std::abs(frame.t - t) < same_time; });
    return found == run.frames.end() ? nullptr : &*found;
}

bool have_all(std::span<const record::RunContents> runs, double t)
{
    return std::ranges::all_of(runs, [t](const record::RunContents& run) { return frame_at(run, t) != nullptr; });
}

double chosen_time(std::span<const record::RunContents> runs, std::span<const double> times)
{
    if (times.size() > 1)
    {
        throw InputError(fmt::format("--time: got {} times for {} runs; expected one", times.size(), runs.size()));
    }
    if (!times.empty())
    {
        const auto lacking = std::ranges::find_if(runs, [&](const record::RunContents& run)
                                                  { return frame_at(run, times.front()) == nullptr; });
        if (lacking != runs.end())
        {
            throw InputError(fmt::format("--time {}: {} has no output then; expected an output time of all {} runs",
                                         times.front(), lacking->folder.string(), runs.size()));
        }
        return times.front();
    }
    for (auto frame = runs[0].frames.rbegin(); frame != runs[0].frames.rend(); ++frame)
    {
        if (frame->t > runs[0].frames.front().t && have_all(runs, frame->t))
        {
            return frame->t;
        }
    }
    throw InputError(fmt::format("no common times: the {} runs have no output after the first at one t; expected "
                                 "output times at the same t",
                                 runs.size()));
}

/// A comparison of surfaces has no need of the particles, which are most of a frame.
TriangleMesh surface_of(const record::FrameFiles& frame)
{
    TriangleMesh mesh = formats::read_surface_vtp(frame.surface).mesh;
    require_finite(frame.surface.string(), mesh.vertices);
    return mesh;
}

void require_same_body(const record::Frame& first, const TriangleMesh& other, const record::RunContents& of,
                       const record::RunContents& against)
{
    const double near = same_place * first.spacing;
    if (other.triangles != first.triangles ||
        !std::ranges::equal(other.vertices, first.surface,
                            [near](const Vec3& a, const Vec3& b) { return norm(a - b) <= near; }))
    {
        throw InputError(fmt::format("{}: is of another body than {}; expected runs of one body, with the same "
                                     "geometry and number of particles, to compare more than two",
                                     of.folder.string(), against.folder.string()));
    }
}

std::vector<MeasureSpread> spreads(std::span<const record::RunContents> runs, double t)
{
    std::vector<MeasureSpread> result;
    for (const formats::NumberColumn& column : runs[0].measures.columns)
    {
        std::vector<double> values;
        for (const record::RunContents& run : runs)
        {
            const formats::NumberColumn* const own = run.measures.find(column.key);
            values.push_back(own == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                            : metrics::interpolate(run.measures.find("t")->values, own->values, t));
        }
        if (column.key == "t" || column.key == "week" ||
            std::ranges::any_of(values, [](double value) { return !std::isfinite(value); }))
        {
            continue;
        }
        double mean = 0.0;
        double squares = 0.0;
        std::ranges::for_each(values, [&](double value) { mean += value / static_cast<double>(values.size()); });
        std::ranges::for_each(values, [&](double value) { squares += (value - mean) * (value - mean); });
        const auto [lowest, highest] = std::ranges::minmax(values);
        result.push_back({measure_key(column), column.unit, mean,
                          std::sqrt(squares / static_cast<double>(values.size() - 1)), lowest, highest});
    }
    return result;
}

} // namespace

RunVariation compare_many_runs(std::span<const std::filesystem::path> folders, std::span<const double> times)
{
    RunVariation result;
    std::ranges::transform(folders, std::back_inserter(result.runs), record::read_run);
    result.t = chosen_time(result.runs, times);
    result.week = record::week_at(result.runs[0].measures, result.t);
    const record::Frame first = record::read_frame(result.runs[0].frames.front());
    std::vector<std::vector<Vec3>> surfaces;
    for (const record::RunContents& run : result.runs)
    {
        require_same_body(first, surface_of(run.frames.front()), run, result.runs[0]);
        surfaces.push_back(surface_of(*frame_at(run, result.t)).vertices);
    }
    std::vector<metrics::SurfaceView> views;
    std::ranges::transform(surfaces, std::back_inserter(views),
                           [&](const std::vector<Vec3>& surface) {
                               return metrics::SurfaceView{surface, first.triangles};
                           });
    result.measures = spreads(result.runs, result.t);
    result.pattern = metrics::pattern_variation({first.surface, first.triangles}, views);
    result.surface = surfaces.front();
    result.triangles = first.triangles;
    return result;
}

std::vector<std::string> comparison_pictures(const RunVariation& /*variation*/)
{
    return {share_picture, deviation_picture};
}

void draw_comparison(const std::filesystem::path& folder, const RunVariation& variation)
{
    view::ColorScale deviation = view::scalar_scale("sulcal_depth", variation.pattern.depth_sd);
    deviation.label = "standard deviation of the depth [mm]";
    view::render_surface(
        variation.surface, variation.triangles,
        std::array{view::SurfacePicture{folder / share_picture,
                                        variation.pattern.sulcal_share,
                                        {"share of the runs that are concave here", 0.0, 1.0, view::ColorMap::viridis}},
                   view::SurfacePicture{folder / deviation_picture, variation.pattern.depth_sd, deviation}},
        fmt::format("{} runs of one body", variation.runs.size()));
}

void write_variation(const std::filesystem::path& file, const RunVariation& variation)
{
    const metrics::PatternVariation& p = variation.pattern;
    formats::write_surface_vtp(
        file, variation.surface, variation.triangles,
        std::array{formats::Field{"sulcal_share", 1, p.sulcal_share}, formats::Field{"depth_mean", 1, p.depth_mean},
                   formats::Field{"depth_sd", 1, p.depth_sd}, formats::Field{"curvature_mean", 1, p.curvature_mean}});
}

} // namespace corticle::study
