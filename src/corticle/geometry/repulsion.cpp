// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/repulsion.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/cell_grid.hpp"

namespace corticle
{

void repulsion_moves(std::span<const Vec3> points, std::int64_t first, double range, double step, double longest,
                     std::vector<Vec3>& moves)
{
    const CellGrid grid(points, range);
    const double range2 = range * range;
    moves.resize(points.size() - static_cast<std::size_t>(first));
    parallel_for(static_cast<std::int64_t>(moves.size()),
                 [&](std::int64_t k)
                 {
                     const Vec3 p = points[first + k];
                     Vec3 push;
                     grid.near(p,
                               [&](std::int32_t, const Vec3& q)
                               {
                                   const Vec3 d = p - q;
                                   const double r2 = squared_norm(d);
                                   if (r2 < range2 && r2 > 0.0)
                                   {
                                       const double r = std::sqrt(r2);
                                       const double gap = 1.0 - r / range;
                                       push += (gap * gap / r) * d;
                                   }
                               });
                     Vec3 move = (step * range) * push;
                     const double length = norm(move);
                     moves[k] = length > longest ? (longest / length) * move : move;
                 });
}

} // namespace corticle
