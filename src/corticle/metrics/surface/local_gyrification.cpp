// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/local_gyrification.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::metrics
{

namespace
{

constexpr double pieces_per_radius = 6.0;
constexpr double places_per_radius = 5.0; ///< where the index is taken; between them it is interpolated

/// A surface as pieces with an area, each at a point.
struct Pieces
{
    std::vector<Vec3> place;
    std::vector<double> area; ///< [mm²]
};

/// Halves a triangle across its longest edge until no edge is longer than `longest`.
void cut_up(const std::array<Vec3, 3>& corner, double longest, Pieces& pieces)
{
    int from = 0;
    double squared = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        const double s = squared_norm(corner[(k + 1) % 3] - corner[k]);
        if (s > squared)
        {
            squared = s;
            from = k;
        }
    }
    const Vec3 a = corner[from];
    const Vec3 b = corner[(from + 1) % 3];
    const Vec3 c = corner[(from + 2) % 3];
    if (squared <= longest * longest)
    {
        pieces.place.push_back((a + b + c) / 3.0);
        pieces.area.push_back(0.5 * norm(cross(b - a, c - a)));
        return;
    }
    const Vec3 middle = 0.5 * (a + b);
    cut_up({a, middle, c}, longest, pieces);
    cut_up({middle, b, c}, longest, pieces);
}

/// Area in balls, summed over pieces; one on the rim counts in part, by the distance of its centre from the rim.
class AreaInBall
{
  public:
    AreaInBall(const Pieces& pieces, double radius)
        : grid_(pieces.place, radius + rim_of_largest(pieces)), area_(pieces.area), radius_(radius)
    {
    }

    double about(const Vec3& centre) const
    {
        double sum = 0.0;
        grid_.near(centre,
                   [&](std::int32_t k, const Vec3& place)
                   {
                       const double inside = radius_ - norm(place - centre);
                       const double width = std::sqrt(area_[k]);
                       sum += width * std::clamp(inside + 0.5 * width, 0.0, width);
                   });
        return sum;
    }

  private:
    static double rim_of_largest(const Pieces& pieces)
    {
        return 0.5 * std::sqrt(*std::max_element(pieces.area.begin(), pieces.area.end()));
    }

    CellGrid grid_;
    const std::vector<double>& area_;
    double radius_;
};

/// One point for each cube of the given edge that holds some: their mean.
std::vector<Vec3> thinned(std::span<const Vec3> points, double edge)
{
    using Key = std::array<std::int64_t, 4>; // cube, then number of the point
    std::vector<Key> keys;
    keys.reserve(points.size());
    for (const Vec3& p : points)
    {
        keys.push_back({static_cast<std::int64_t>(std::floor(p.x / edge)),
                        static_cast<std::int64_t>(std::floor(p.y / edge)),
                        static_cast<std::int64_t>(std::floor(p.z / edge)), std::ssize(keys)});
    }
    std::sort(keys.begin(), keys.end());
    const auto same_cube = [](const Key& a, const Key& b) { return std::equal(a.begin(), a.begin() + 3, b.begin()); };
    std::vector<Vec3> means;
    for (auto first = keys.begin(); first != keys.end();)
    {
        const auto last = std::find_if(first, keys.end(), [&](const Key& key) { return !same_cube(key, *first); });
        Vec3 sum;
        std::for_each(first, last, [&](const Key& key) { sum += points[key[3]]; });
        means.push_back(sum / static_cast<double>(last - first));
        first = last;
    }
    return means;
}

/// Values at the means of cubes, interpolated to the points in them.
std::vector<double> interpolated(std::span<const Vec3> places, std::span<const double> values,
                                 std::span<const Vec3> points, double edge)
{
    const double support = 2.0 * edge; // beyond the diagonal of a cube
    const CellGrid grid(places, support);
    std::vector<double> result(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t v)
                 {
                     double sum = 0.0;
                     double weights = 0.0;
                     grid.near(points[v],
                               [&](std::int32_t k, const Vec3& place)
                               {
                                   const double near =
                                       std::max(0.0, 1.0 - squared_norm(place - points[v]) / (support * support));
                                   sum += near * near * values[k];
                                   weights += near * near;
                               });
                     result[v] = sum / weights;
                 });
    return result;
}

} // namespace

std::vector<double> local_gyrification(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                       const geometry::SurfaceTree& outer, double radius)
{
    const TriangleMesh& envelope = outer.mesh();
    const double least = 0.01 * std::sqrt(surface_area(envelope.vertices, envelope.triangles));
    if (!(radius >= least) || !std::isfinite(radius))
    {
        throw InputError(
            fmt::format("local gyrification: got a radius of {:g} mm; expected at least {:.3g} mm", radius, least));
    }
    Pieces on_surface{std::vector<Vec3>(vertices.size()), vertex_areas(vertices, triangles)};
    parallel_for(std::ssize(vertices),
                 [&](std::int64_t v) { on_surface.place[v] = outer.closest(vertices[v]).position; });
    Pieces on_outer;
    for (const Triangle& t : envelope.triangles)
    {
        cut_up({envelope.vertices[t[0]], envelope.vertices[t[1]], envelope.vertices[t[2]]}, radius / pieces_per_radius,
               on_outer);
    }
    const AreaInBall surface_area_in(on_surface, radius);
    const AreaInBall outer_area_in(on_outer, radius);
    const double apart = radius / places_per_radius;
    const std::vector<Vec3> places = thinned(on_surface.place, apart);
    std::vector<double> index(places.size());
    parallel_for(std::ssize(places),
                 [&](std::int64_t k) { index[k] = surface_area_in.about(places[k]) / outer_area_in.about(places[k]); });
    return interpolated(places, index, on_surface.place, apart);
}

} // namespace corticle::metrics
