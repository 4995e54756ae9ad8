// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/comparison_bodies.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/metrics/comparison.hpp"
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/report/plain_text.hpp"
#include "corticle/report/sources.hpp"
#include "corticle/study/comparison/real_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

std::vector<double> distances(std::span<const Vec3> points, const geometry::SurfaceTree& other)
{
    std::vector<double> result(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t v) { result[v] = std::sqrt(other.closest(points[v]).squared_distance); });
    return result;
}

/// Gives both frames their distances to the other surface.
void add_distances(Body& a, Body& b, std::size_t frame)
{
    const geometry::SurfaceTree tree_a(a.frames[frame].points, a.triangles);
    const geometry::SurfaceTree tree_b(b.frames[frame].points, b.triangles);
    a.frames[frame].scalars.emplace_back("distance", distances(a.frames[frame].points, tree_b));
    b.frames[frame].scalars.emplace_back("distance", distances(b.frames[frame].points, tree_a));
}

/// Numbers of the frames of a run at given times.
std::vector<std::size_t> frames_at(const record::RunContents& run, std::span<const double> times)
{
    std::vector<std::size_t> chosen;
    for (const double t : times)
    {
        const auto nearest = std::ranges::min_element(
            run.frames, {}, [&](const record::FrameFiles& frame) { return std::abs(frame.t - t); });
        chosen.push_back(static_cast<std::size_t>(nearest - run.frames.begin()));
    }
    return chosen;
}

/// Middle of a surface: mean of its triangles, weighted with area.
Vec3 middle_of(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    Vec3 sum;
    double area = 0.0;
    for (const Triangle& triangle : triangles)
    {
        const Vec3& a = points[static_cast<std::size_t>(triangle[0])];
        const Vec3& b = points[static_cast<std::size_t>(triangle[1])];
        const Vec3& c = points[static_cast<std::size_t>(triangle[2])];
        const double size = norm(cross(b - a, c - a));
        sum += size * (a + b + c);
        area += 3.0 * size;
    }
    return sum / area;
}

void move(std::vector<Vec3>& points, const Vec3& by)
{
    for (Vec3& point : points)
    {
        point += by;
    }
}

study::RealSurfaceOptions reading_of(const Json& comparison)
{
    const Json reading = comparison.value("reading", Json::object());
    study::RealSurfaceOptions options;
    const std::string unit = reading.value("unit", std::string("mm"));
    options.unit = unit == "cm"  ? formats::UnitOfLength::cm
                   : unit == "m" ? formats::UnitOfLength::m
                                 : formats::UnitOfLength::mm;
    options.coordinates = reading.value("coordinates", std::string("scanner")) == "file"
                              ? formats::Coordinates::file
                              : formats::Coordinates::scanner;
    options.mask.labels = reading.value("labels", std::vector<std::int64_t>{});
    options.mask.closing_mm = reading.value("closing_mm", options.mask.closing_mm);
    options.mask.smoothing_mm = reading.value("smoothing_mm", options.mask.smoothing_mm);
    return options;
}

Body real_body(const fs::path& file, const std::string& name, double place, bool is_week, const Json& comparison)
{
    study::RealSurfaceReading reading = study::read_real_surface(file, reading_of(comparison));
    const metrics::FoldFields folds = metrics::fold_fields(reading.surface.vertices, reading.surface.triangles);
    Body body{name, true, reading.surface.triangles, {}, 1};
    BodyFrame& frame = body.frames.emplace_back();
    frame.t = is_week ? 0.0 : place;
    frame.week = is_week ? place : frame.week;
    frame.points = std::move(reading.surface.vertices);
    frame.scalars = {{"sulcal_depth", folds.sulcal_depth},
                     {"mean_curvature", folds.curvature.mean},
                     {"local_gyrification", folds.local_gyrification}};
    return body;
}

/// The output time of the run whose place on the axis is nearest.
std::size_t nearest_place(const Json& places, double at)
{
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        nearest = std::abs(places[k].get<double>() - at) < std::abs(places[nearest].get<double>() - at) ? k : nearest;
    }
    return nearest;
}

RealPair real_pair(const record::RunContents& run, const std::string& run_name, const fs::path& folder,
                   const Json& comparison, const Json& real)
{
    const bool is_week = comparison.value("axis", std::string()) == "week";
    const double place = real.at(is_week ? "week" : "t").get<double>();
    const std::string given = real.value("name", std::string());
    const fs::path file = given.substr(0, given.rfind('@'));
    const std::string name = fmt::format("{}, {} {:.4g}", name_of(file), is_week ? "week" : "t =", place);
    const std::array chosen{nearest_place(comparison.at(is_week ? "week" : "t"), place)};
    Body simulated = read_body(run, chosen, {});
    BodyFrame& frame = simulated.frames.front();
    simulated.name = std::isnan(frame.week) ? fmt::format("{}, t = {:.3g}", run_name, frame.t)
                                            : fmt::format("{}, week {:.4g}", run_name, frame.week);
    Body measured = real_body(found_from(folder, file.string()), name, place, is_week, comparison);
    BodyFrame& real_frame = measured.frames.front();
    real_frame.t = frame.t; // shown together
    move(real_frame.points,
         middle_of(frame.points, simulated.triangles) - middle_of(real_frame.points, measured.triangles));
    add_distances(simulated, measured, 0);
    const metrics::SurfaceDistance distance =
        metrics::surface_distance({frame.points, simulated.triangles}, {real_frame.points, measured.triangles});
    return {name,
            {{"mean", distance.mean}, {"p95", distance.percentile_95}, {"hausdorff", distance.hausdorff}},
            {std::move(simulated), std::move(measured)}};
}

} // namespace

std::vector<Body> bodies_of_runs(const std::array<fs::path, 2>& folders, const std::array<std::string, 2>& names,
                                 const Json& frames)
{
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < 2; ++k)
    {
        std::vector<double> times;
        for (const Json& frame : frames)
        {
            times.push_back(frame.at("t").at(k).get<double>());
        }
        const record::RunContents run = record::read_run(folders[k]);
        bodies.push_back(read_body(run, frames_at(run, times), names[k]));
    }
    for (std::size_t frame = 0; frame < bodies[0].frames.size(); ++frame)
    {
        add_distances(bodies[0], bodies[1], frame);
        bodies[1].frames[frame].t = bodies[0].frames[frame].t; // within 1 % of each other, shown together
    }
    return bodies;
}

RealPairs bodies_of_reals(const fs::path& folder, const Json& comparison, std::vector<std::string>& notes)
{
    const Json run_entry = comparison.value("run", Json::object());
    const record::RunContents run = record::read_run(found_from(folder, run_entry.value("folder", std::string())));
    const std::string run_name = without_paths(run_entry.value("name", std::string()));
    const bool is_week = comparison.value("axis", std::string()) == "week";
    const Json& places = comparison.at(is_week ? "week" : "t");
    RealPairs pairs;
    for (const Json& real : comparison.at("reals"))
    {
        const double place = real.at(is_week ? "week" : "t").get<double>();
        if (place >= places.front().get<double>() && place <= places.back().get<double>())
        {
            pairs.push_back(real_pair(run, run_name, folder, comparison, real));
        }
    }
    notes.push_back(
        "Each real surface stands beside the output time of the run that is nearest to its week. Its middle "
        "is moved to that of the run, nothing is turned or scaled; distances are taken then.");
    return pairs;
}

} // namespace corticle::report
