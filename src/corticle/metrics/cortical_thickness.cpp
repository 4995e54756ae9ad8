// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/cortical_thickness.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <limits>

namespace corticle::metrics
{

namespace
{

constexpr double support_in_spacings = 1.5;

Vec3 carried_by(const CarriedCloud& cloud, std::int32_t particle, const Vec3& X)
{
    return cloud.current[particle] + cloud.F[particle] * (X - cloud.reference[particle]);
}

std::int32_t nearest_particle(const CarriedCloud& cloud, const Vec3& X)
{
    std::int32_t nearest = 0;
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cloud.reference.size(); ++i)
    {
        const double s = squared_norm(cloud.reference[i] - X);
        if (s < squared)
        {
            squared = s;
            nearest = static_cast<std::int32_t>(i);
        }
    }
    return nearest;
}

} // namespace

std::vector<Vec3> carried_points(const CarriedCloud& cloud, std::span<const Vec3> points)
{
    const double support = support_in_spacings * cloud.spacing;
    const CellGrid grid(cloud.reference, support);
    std::vector<Vec3> carried(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t k)
                 {
                     const Vec3& X = points[k];
                     Vec3 sum;
                     double weights = 0.0;
                     grid.near(X,
                               [&](std::int32_t i, const Vec3& X_i)
                               {
                                   const double near = 1.0 - squared_norm(X - X_i) / (support * support);
                                   if (near > 0.0)
                                   {
                                       sum += near * near * carried_by(cloud, i, X);
                                       weights += near * near;
                                   }
                               });
                     carried[k] = weights > 0.0 ? sum / weights : carried_by(cloud, nearest_particle(cloud, X), X);
                 });
    return carried;
}

std::vector<double> cortical_thickness(std::span<const Vec3> outer, std::span<const Vec3> inner,
                                       std::span<const Triangle> triangles)
{
    const geometry::SurfaceTree outer_tree(outer, triangles);
    const geometry::SurfaceTree inner_tree(inner, triangles);
    std::vector<double> thickness(outer.size());
    parallel_for(std::ssize(outer),
                 [&](std::int64_t v)
                 {
                     thickness[v] = 0.5 * (std::sqrt(inner_tree.closest(outer[v]).squared_distance) +
                                           std::sqrt(outer_tree.closest(inner[v]).squared_distance));
                 });
    return thickness;
}

} // namespace corticle::metrics
