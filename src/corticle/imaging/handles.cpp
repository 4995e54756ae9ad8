// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/handles.hpp"

#include "corticle/imaging/distance_transform.hpp"
#include "corticle/imaging/homotopic_growth.hpp"
#include "corticle/imaging/kuhn_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace corticle::imaging
{

namespace
{

/// Fills that are tried, smallest first: each costs one growth.
constexpr std::size_t most_trials = 12;

/// Fills count double: in a brain, a bridge over a fissure is more often false than the fissure.
constexpr double fill_weight = 2.0;

/// What the change of a voxel costs: more where the value is far from the level.
double change_cost(float value, float level)
{
    return 0.5 + 4.0 * static_cast<double>(std::abs(value - level));
}

/// Voxels that are in `a` and not in `b`.
Mask difference(const Mask& a, const Mask& b)
{
    Mask result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(),
                   [](std::uint8_t in_a, std::uint8_t in_b) { return static_cast<std::uint8_t>(in_a & ~in_b & 1); });
    return result;
}

double cost_of(const Mask& changed, std::span<const float> value, float level)
{
    double cost = 0.0;
    for (std::size_t voxel = 0; voxel < changed.size(); ++voxel)
    {
        cost += changed[voxel] == 1 ? change_cost(value[voxel], level) : 0.0;
    }
    return cost;
}

void list_changes(const VoxelGrid& grid, const Mask& changed, bool filled, std::vector<HandleChange>& changes)
{
    const Components components = kuhn_components(grid, changed, 1);
    std::vector<HandleChange> found(components.sizes.size());
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        if (components.number[voxel] > 0)
        {
            HandleChange& change = found[components.number[voxel]];
            change.place += grid.position(voxel);
            ++change.voxels;
            change.filled = filled;
        }
    }
    for (std::size_t k = 1; k < found.size(); ++k)
    {
        found[k].place = found[k].place / static_cast<double>(found[k].voxels);
        changes.push_back(found[k]);
    }
}

/// Cuts what is left of the handles after some tunnels were filled, and weighs all changes.
struct Attempt
{
    Mask filled; ///< the mask and the fills
    Mask ball;
    double cost = 0.0; ///< of fills and cuts
};

class HandleRemoval
{
  public:
    HandleRemoval(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, float level)
        : grid_(grid), mask_(mask), value_(value), level_(level), depth_(squared_distance_to(grid, mask, 0))
    {
    }

    Attempt attempt(Mask filled) const
    {
        Attempt result;
        result.ball = grow_ball(grid_, filled, value_, depth_);
        result.cost = cost_of(difference(filled, result.ball), value_, level_) +
                      fill_weight * cost_of(difference(filled, mask_), value_, level_);
        result.filled = std::move(filled);
        return result;
    }

    /// Takes one fill after another, smallest first, where it makes the whole change smaller.
    Attempt best() const
    {
        Attempt best = attempt(mask_);
        const Mask ball = shrink_ball(grid_, mask_, value_, squared_distance_to(grid_, mask_, 1));
        const Components fills = kuhn_components(grid_, difference(ball, mask_), 1);
        std::vector<std::int32_t> order(fills.sizes.size() - 1);
        std::iota(order.begin(), order.end(), 1);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::int32_t a, std::int32_t b) { return fills.sizes[a] < fills.sizes[b]; });
        order.resize(std::min(order.size(), most_trials));
        for (const std::int32_t fill : order)
        {
            if (fill_weight * static_cast<double>(fills.sizes[fill]) * change_cost(0.0F, 0.0F) >= best.cost)
            {
                break;
            }
            Mask filled = best.filled;
            for (std::size_t voxel = 0; voxel < filled.size(); ++voxel)
            {
                filled[voxel] |= static_cast<std::uint8_t>(fills.number[voxel] == fill);
            }
            Attempt next = attempt(std::move(filled));
            if (next.cost < best.cost)
            {
                best = std::move(next);
            }
        }
        return best;
    }

  private:
    const VoxelGrid& grid_;
    const Mask& mask_;
    std::span<const float> value_;
    float level_;
    std::vector<float> depth_;
};

} // namespace

BallMask remove_handles(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, float level)
{
    require_voxels(grid, "mask", mask.size());
    require_voxels(grid, "values", value.size());
    Attempt best = HandleRemoval(grid, mask, value, level).best();
    BallMask result;
    list_changes(grid, difference(mask, best.ball), false, result.changes);
    list_changes(grid, difference(best.ball, mask), true, result.changes);
    result.mask = std::move(best.ball);
    return result;
}

} // namespace corticle::imaging
