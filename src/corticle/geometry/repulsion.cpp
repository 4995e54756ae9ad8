// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/repulsion.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace corticle::geometry
{

namespace
{

/// Separations from the points in range, gathered first and weighed in one loop without branches.
class Push
{
  public:
    void add(const Vec3& separation, double range)
    {
        const double r2 = squared_norm(separation);
        separations_[count_] = separation;
        ranges_[count_] = range;
        count_ += r2 < range * range && r2 > 0.0 ? 1 : 0;
        if (count_ == capacity)
        {
            weigh();
        }
    }

    /// sum_j (1 - r_ij / range_ij)² r_ij / |r_ij| over what was added; starts anew.
    Vec3 take()
    {
        weigh();
        return std::exchange(sum_, Vec3{});
    }

  private:
    static constexpr int capacity = 64;

    void weigh()
    {
        for (int k = 0; k < count_; ++k)
        {
            const double r = norm(separations_[k]);
            const double gap = 1.0 - r / ranges_[k];
            sum_ += (gap * gap / r) * separations_[k];
        }
        count_ = 0;
    }

    int count_ = 0;
    Vec3 sum_;
    std::array<Vec3, capacity> separations_;
    std::array<double, capacity> ranges_;
};

} // namespace

void repulsion_moves(std::span<const Vec3> points, std::int64_t first, std::span<const double> ranges, double step,
                     double longest, std::vector<Vec3>& moves)
{
    require_size("ranges", ranges.size(), points.size());
    if (first < 0 || first > std::ssize(points))
    {
        throw InputError(fmt::format("first point to move: got {}, expected 0 to {}", first, points.size()));
    }
    if (points.empty())
    {
        moves.clear();
        return;
    }
    const CellGrid grid(points, *std::ranges::max_element(ranges));
    moves.resize(points.size() - static_cast<std::size_t>(first));
    parallel_blocks(static_cast<std::int64_t>(moves.size()),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        Push push;
                        for (std::int64_t k = begin; k < end; ++k)
                        {
                            const Vec3 p = points[first + k];
                            const double range = ranges[first + k];
                            grid.near(p, [&](std::int32_t j, const Vec3& q)
                                      { push.add(p - q, 0.5 * (range + ranges[j])); });
                            const Vec3 move = (step * range) * push.take();
                            const double length = norm(move);
                            moves[k] = length > longest * range ? (longest * range / length) * move : move;
                        }
                    });
}

} // namespace corticle::geometry
