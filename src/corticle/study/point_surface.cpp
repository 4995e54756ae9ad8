// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/point_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/formats/number_table.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/point_tree.hpp"
#include "corticle/metrics/comparison.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/metrics/surface_measures.hpp"
#include "corticle/study/delaunay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;

constexpr double limit_over_distance = 5.0 / 3.0; ///< default length limit over the mean distance of nearest points
constexpr double missed_over_distance = 0.5;      ///< surface farther than this from the other is missed

std::vector<Vec3> table_points(const fs::path& file)
{
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    const formats::NumberTable table = formats::read_number_table(file, axes);
    std::vector<Vec3> points(table.row_count());
    for (int axis = 0; axis < 3; ++axis)
    {
        const std::string key(1, "xyz"[axis]);
        const formats::NumberColumn* const column = table.find(key);
        if (column == nullptr)
        {
            throw InputError(fmt::format("{}: no column {}; expected columns x, y and z", file.string(), key));
        }
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            points[i][axis] = column->values[i];
        }
    }
    return points;
}

std::vector<Vec3> read_points(const fs::path& file)
{
    std::vector<Vec3> points = file.extension() == ".vtu"   ? formats::read_particles_vtu(file).points
                               : file.extension() == ".csv" ? table_points(file)
                                                            : formats::read_surface(file).vertices;
    if (points.size() < 4 || !std::ranges::all_of(points, is_finite))
    {
        throw InputError(
            fmt::format("{}: got {} points, expected at least four, all finite", file.string(), points.size()));
    }
    return points;
}

/// Mean distance of a point to the one nearest to it.
double mean_distance(std::span<const Vec3> points)
{
    const PointTree tree(points);
    return parallel_sum(std::ssize(points),
                        [&](std::int64_t i) { return std::sqrt(tree.nearest_squared<2>(points[i])[1]); }) /
           static_cast<double>(points.size());
}

/// surface_NAME.vtp of particles_NAME.vtu, if it is there.
fs::path carried_file(const fs::path& file)
{
    const std::string name = file.filename().string();
    if (!name.starts_with("particles_") || file.extension() != ".vtu")
    {
        return {};
    }
    const fs::path carried = file.parent_path() / ("surface_" + name.substr(10, name.size() - 14) + ".vtp");
    std::error_code error;
    return fs::exists(carried, error) ? carried : fs::path();
}

/// Places on a surface, the area each stands for, and how far it is from another surface.
struct Samples
{
    std::vector<Vec3> places;
    std::vector<double> areas;
    std::vector<double> distances;

    void measure(const geometry::SurfaceTree& other)
    {
        distances.resize(places.size());
        parallel_for(std::ssize(places),
                     [&](std::int64_t i) { distances[i] = std::sqrt(other.closest(places[i]).squared_distance); });
    }
    /// Share of the area farther than `distance`.
    double share_beyond(double distance) const
    {
        double beyond = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            beyond += distances[i] > distance ? areas[i] : 0.0;
        }
        return beyond / std::accumulate(areas.begin(), areas.end(), 0.0);
    }
};

Samples at_triangles(const TriangleMesh& surface)
{
    Samples samples;
    for (const Triangle& t : surface.triangles)
    {
        const Vec3 a = surface.vertices[t[0]];
        const Vec3 b = surface.vertices[t[1]];
        const Vec3 c = surface.vertices[t[2]];
        samples.places.push_back((a + b + c) / 3.0);
        samples.areas.push_back(0.5 * norm(cross(b - a, c - a)));
    }
    return samples;
}

struct DistanceStatistics
{
    double mean = 0.0;
    double percentile_95 = 0.0;
    double largest = 0.0;
    Vec3 farthest;
};

/// Of both together, weighted with area.
DistanceStatistics statistics(const Samples& a, const Samples& b)
{
    struct One
    {
        double distance;
        double area;
        Vec3 place;
    };
    std::vector<One> all;
    for (const Samples* samples : {&a, &b})
    {
        for (std::size_t i = 0; i < samples->places.size(); ++i)
        {
            all.push_back({samples->distances[i], samples->areas[i], samples->places[i]});
        }
    }
    std::ranges::stable_sort(all, {}, &One::distance);
    const double area =
        std::accumulate(all.begin(), all.end(), 0.0, [](double sum, const One& one) { return sum + one.area; });
    DistanceStatistics result{0.0, all.back().distance, all.back().distance, all.back().place};
    double reached = 0.0;
    for (const One& one : all)
    {
        result.mean += one.distance * one.area / area;
        if (reached < 0.95 * area && reached + one.area >= 0.95 * area)
        {
            result.percentile_95 = one.distance;
        }
        reached += one.area;
    }
    return result;
}

/// Area-weighted mean of a field of the carried surface over its triangles that are farther than `distance`.
double mean_beyond(const formats::SurfaceFile& carried, const std::string& name, const Samples& samples,
                   double distance)
{
    const auto field = std::ranges::find(carried.fields, name, &std::pair<std::string, std::vector<double>>::first);
    double sum = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; field != carried.fields.end() && i < samples.places.size(); ++i)
    {
        if (samples.distances[i] > distance)
        {
            for (const std::int32_t corner : carried.mesh.triangles[i])
            {
                sum += samples.areas[i] * field->second[corner] / 3.0;
            }
            area += samples.areas[i];
        }
    }
    return area > 0.0 ? sum / area : std::nan("");
}

void add_sizes(std::vector<metrics::SurfaceRow>& rows, const std::string& prefix, const metrics::SurfaceMeasures& sizes)
{
    for (const metrics::SizeColumn& column : metrics::size_columns())
    {
        rows.push_back({prefix + std::string(column.key), std::string(column.unit), sizes.*column.value});
    }
}

/// How far the surface from points is from the one that the run carries along. @return distances at its triangles [mm]
std::vector<double> add_comparison(std::vector<metrics::SurfaceRow>& rows, const TriangleMesh& found,
                                   const metrics::SurfaceMeasures& sizes, const formats::SurfaceFile& carried,
                                   double point_distance)
{
    const metrics::SurfaceMeasures expected = metrics::measure_surface(carried.mesh.vertices, carried.mesh.triangles);
    add_sizes(rows, "carried_", expected);
    Samples of_found = at_triangles(found);
    of_found.measure(geometry::SurfaceTree(carried.mesh.vertices, carried.mesh.triangles));
    Samples of_carried = at_triangles(carried.mesh);
    of_carried.measure(geometry::SurfaceTree(found.vertices, found.triangles));
    const DistanceStatistics far = statistics(of_found, of_carried);
    const double missed = missed_over_distance * point_distance;
    rows.push_back({"area_error", "%", metrics::percent_difference(expected.area_mm2, sizes.area_mm2)});
    rows.push_back({"volume_error", "%", metrics::percent_difference(expected.volume_mm3, sizes.volume_mm3)});
    rows.push_back({"gi_hull_error", "%", metrics::percent_difference(expected.gi_hull, sizes.gi_hull)});
    rows.push_back({"distance_mean_mm", "mm", far.mean});
    rows.push_back({"distance_95_mm", "mm", far.percentile_95});
    rows.push_back({"distance_hausdorff_mm", "mm", far.largest});
    rows.push_back({"farthest_x_mm", "mm", far.farthest.x});
    rows.push_back({"farthest_y_mm", "mm", far.farthest.y});
    rows.push_back({"farthest_z_mm", "mm", far.farthest.z});
    rows.push_back({"false_area_share", "-", of_found.share_beyond(missed)});
    rows.push_back({"missed_area_share", "-", of_carried.share_beyond(missed)});
    rows.push_back({"sulcal_depth_mm", "mm", mean_beyond(carried, "sulcal_depth", of_carried, -1.0)});
    rows.push_back({"missed_sulcal_depth_mm", "mm", mean_beyond(carried, "sulcal_depth", of_carried, missed)});
    return of_found.distances;
}

/// Distances at triangles, at their vertices: the largest of the triangles about each.
std::vector<double> at_vertices(const TriangleMesh& surface, std::span<const double> at_triangles)
{
    std::vector<double> values(surface.vertices.size(), 0.0);
    for (std::size_t k = 0; k < at_triangles.size(); ++k)
    {
        for (const std::int32_t corner : surface.triangles[k])
        {
            values[corner] = std::max(values[corner], at_triangles[k]);
        }
    }
    return values;
}

} // namespace

std::vector<metrics::SurfaceRow> measure_point_surface(const PointSurfaceRequest& request)
{
    const std::vector<Vec3> points = read_points(request.file);
    const double distance = mean_distance(points);
    const double limit = request.length_limit_mm.value_or(limit_over_distance * distance);
    const DelaunayBody body = delaunay_body(points, limit, request.file.string());
    const TriangleMesh& surface = body.boundary.surface;
    const metrics::SurfaceMeasures sizes = metrics::measure_surface(surface.vertices, surface.triangles);
    std::vector<metrics::SurfaceRow> rows{{"points", "-", static_cast<double>(points.size())},
                                          {"points_left_out", "-", static_cast<double>(body.points_left_out)},
                                          {"point_distance_mm", "mm", distance},
                                          {"length_limit_mm", "mm", limit},
                                          {"tets", "-", static_cast<double>(body.mesh.tets.size())}};
    add_sizes(rows, "", sizes);
    std::vector<double> distances;
    if (const fs::path carried = carried_file(request.file); !carried.empty())
    {
        distances = add_comparison(rows, surface, sizes, formats::read_surface_vtp(carried), distance);
    }
    if (!request.out.empty())
    {
        const std::vector<double> shown = at_vertices(surface, distances);
        const std::vector<formats::Field> fields{formats::Field{"distance", 1, shown}};
        formats::write_surface_vtp(request.out, surface.vertices, surface.triangles,
                                   distances.empty() ? std::span<const formats::Field>()
                                                     : std::span<const formats::Field>(fields));
    }
    return rows;
}

} // namespace corticle::study
