// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/local_gyrification.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/cell_grid.hpp"

#include <fmt/format.h>

namespace corticle
{

namespace
{

constexpr double pieces_per_radius = 10.0;

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

} // namespace

std::vector<double> local_gyrification(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                       const SurfaceTree& outer, double radius)
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
    std::vector<double> index(vertices.size());
    parallel_for(std::ssize(vertices),
                 [&](std::int64_t v)
                 {
                     const Vec3& centre = on_surface.place[v];
                     index[v] = surface_area_in.about(centre) / outer_area_in.about(centre);
                 });
    return index;
}

} // namespace corticle
