// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/repulsion.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

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
    explicit Push(double range) : range_(range) {}

    void add(const Vec3& separation)
    {
        const double r2 = squared_norm(separation);
        separations_[count_] = separation;
        count_ += r2 < range_ * range_ && r2 > 0.0 ? 1 : 0;
        if (count_ == capacity)
        {
            weigh();
        }
    }

    /// sum_j (1 - r_ij / range)² r_ij / |r_ij| over what was added; starts anew.
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
            const double gap = 1.0 - r / range_;
            sum_ += (gap * gap / r) * separations_[k];
        }
        count_ = 0;
    }

    double range_;
    int count_ = 0;
    Vec3 sum_;
    std::array<Vec3, capacity> separations_;
};

} // namespace

void repulsion_moves(std::span<const Vec3> points, std::int64_t first, double range, double step, double longest,
                     std::vector<Vec3>& moves)
{
    require_positive("range of the repulsion [mm]", range);
    if (first < 0 || first > std::ssize(points))
    {
        throw InputError(fmt::format("first point to move: got {}, expected 0 to {}", first, points.size()));
    }
    const CellGrid grid(points, range);
    moves.resize(points.size() - static_cast<std::size_t>(first));
    parallel_blocks(static_cast<std::int64_t>(moves.size()),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        Push push(range);
                        for (std::int64_t k = begin; k < end; ++k)
                        {
                            const Vec3 p = points[first + k];
                            grid.near(p, [&](std::int32_t, const Vec3& q) { push.add(p - q); });
                            const Vec3 move = (step * range) * push.take();
                            const double length = norm(move);
                            moves[k] = length > longest ? (longest / length) * move : move;
                        }
                    });
}

} // namespace corticle::geometry
