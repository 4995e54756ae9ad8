// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/homotopic_growth.hpp"

#include "corticle/imaging/kuhn_grid.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace corticle::imaging
{

namespace
{

/// A voxel that may change sides; the greatest goes first.
struct Candidate
{
    float first;
    float second;
    std::int64_t voxel;

    friend bool operator<(const Candidate& a, const Candidate& b)
    {
        return std::tie(a.first, a.second, b.voxel) < std::tie(b.first, b.second, a.voxel);
    }
};

/// Moves the front between two sides, one simple voxel after another. A voxel that is refused comes back when one of
/// its neighbours has changed sides.
class Front
{
  public:
    /// Voxels of `side` != `joins` may change to it, where `open` is 1.
    Front(const VoxelGrid& grid, Mask side, Mask open, std::uint8_t joins)
        : offsets_(kuhn_offsets(grid)), side_(std::move(side)), open_(std::move(open)), joins_(joins)
    {
    }

    template <class Rank>
    void join(std::int64_t voxel, const Rank& rank)
    {
        side_[voxel] = joins_;
        open_[voxel] = 0;
        for (const std::int64_t offset : offsets_)
        {
            push(voxel + offset, rank);
        }
    }

    template <class Rank>
    void push(std::int64_t voxel, const Rank& rank)
    {
        if (open_[voxel] == 1)
        {
            open_[voxel] = 2;
            queue_.push(rank(voxel));
        }
    }

    template <class Rank>
    Mask run(const Rank& rank)
    {
        while (!queue_.empty())
        {
            const std::int64_t voxel = queue_.top().voxel;
            queue_.pop();
            open_[voxel] = 1;
            if (is_simple(neighbors_inside(voxel)))
            {
                join(voxel, rank);
            }
        }
        return std::move(side_);
    }

  private:
    unsigned neighbors_inside(std::int64_t voxel) const
    {
        unsigned inside = 0;
        for (int k = 0; k < kuhn_neighbors; ++k)
        {
            inside |= static_cast<unsigned>(side_[voxel + offsets_[k]]) << k;
        }
        return inside;
    }

    std::array<std::int64_t, kuhn_neighbors> offsets_;
    Mask side_;
    Mask open_; ///< 1 may change sides, 2 waits in the queue
    std::uint8_t joins_;
    std::priority_queue<Candidate> queue_;
};

} // namespace

Mask grow_ball(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, std::span<const float> depth)
{
    require_voxels(grid, "mask", mask.size());
    require_voxels(grid, "values", value.size());
    require_voxels(grid, "depths", depth.size());
    const auto rank = [&](std::int64_t voxel) { return Candidate{value[voxel], depth[voxel], voxel}; };
    std::int64_t seed = -1;
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        if (mask[voxel] == 1 && (seed < 0 || depth[voxel] > depth[seed]))
        {
            seed = voxel;
        }
    }
    Front front(grid, Mask(mask.size(), 0), mask, 1);
    front.join(seed, rank);
    return front.run(rank);
}

Mask shrink_ball(const VoxelGrid& grid, const Mask& mask, std::span<const float> value, std::span<const float> distance)
{
    require_voxels(grid, "mask", mask.size());
    require_voxels(grid, "values", value.size());
    require_voxels(grid, "distances", distance.size());
    const auto rank = [&](std::int64_t voxel) { return Candidate{-value[voxel], distance[voxel], voxel}; };
    Mask ball(mask.size());
    Mask open(mask.size());
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        ball[voxel] = grid.is_outermost(voxel) ? 0 : 1;
        open[voxel] = ball[voxel] == 1 && mask[voxel] == 0 ? 1 : 0;
    }
    const auto offsets = kuhn_offsets(grid);
    Front front(grid, ball, std::move(open), 0);
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        const bool by_the_wall =
            ball[voxel] == 1 &&
            std::any_of(offsets.begin(), offsets.end(), [&](std::int64_t offset) { return ball[voxel + offset] == 0; });
        if (by_the_wall)
        {
            front.push(voxel, rank);
        }
    }
    return front.run(rank);
}

} // namespace corticle::imaging
