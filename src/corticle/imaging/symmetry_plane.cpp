// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/symmetry_plane.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/imaging/smoothing.hpp"

#include <algorithm>
#include <numbers>

namespace corticle::imaging
{

namespace
{

constexpr double blur_mm = 2.0; ///< of the mask, so that the overlap changes smoothly with the plane
constexpr std::int64_t most_samples = 8000;

/// Shift from the centroid [mm], tilts about y and z [rad].
using Pose = std::array<double, 3>;

class Symmetry
{
  public:
    Symmetry(const VoxelGrid& grid, const Mask& mask)
        : grid_(grid), blurred_(mask.begin(), mask.end()), to_index_(inverse(grid.frame.linear))
    {
        smooth_gaussian(grid, blur_mm, blurred_);
        const std::int64_t every = voxel_count(mask) / most_samples + 1;
        std::int64_t inside = 0;
        for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
        {
            if (mask[voxel] == 1 && inside++ % every == 0)
            {
                samples_.push_back(grid.position(voxel));
                centroid_ += samples_.back();
            }
        }
        centroid_ = centroid_ / static_cast<double>(samples_.size());
    }

    Plane plane(const Pose& pose) const
    {
        const Vec3 normal = normalized({1.0, std::tan(pose[2]), std::tan(pose[1])});
        return {normal, dot(normal, centroid_) + pose[0]};
    }

    /// Overlap of the mask with its mirror image.
    double overlap(const Pose& pose) const
    {
        const Plane mirror = plane(pose);
        return parallel_sum(static_cast<std::int64_t>(samples_.size()),
                            [&](std::int64_t k)
                            {
                                const Vec3& p = samples_[k];
                                const double height = dot(mirror.normal, p) - mirror.offset;
                                return value_at(p - 2.0 * height * mirror.normal);
                            });
    }

  private:
    /// Trilinear; 0 outside the grid.
    double value_at(const Vec3& place) const
    {
        const Vec3 index = to_index_ * (place - grid_.frame.origin);
        std::array<std::int64_t, 3> low{};
        for (int axis = 0; axis < 3; ++axis)
        {
            if (!(index[axis] >= 0.0) || index[axis] >= static_cast<double>(grid_.size[axis] - 1))
            {
                return 0.0;
            }
            low[axis] = static_cast<std::int64_t>(index[axis]);
        }
        double sum = 0.0;
        for (int corner = 0; corner < 8; ++corner)
        {
            double weight = 1.0;
            std::int64_t voxel = grid_.index(low[0], low[1], low[2]);
            for (int axis = 0; axis < 3; ++axis)
            {
                const bool high = (corner >> axis & 1) != 0;
                const double share = index[axis] - static_cast<double>(low[axis]);
                weight *= high ? share : 1.0 - share;
                voxel += high ? grid_.stride(axis) : 0;
            }
            sum += weight * static_cast<double>(blurred_[voxel]);
        }
        return sum;
    }

    const VoxelGrid& grid_;
    std::vector<float> blurred_;
    Mat3 to_index_;
    std::vector<Vec3> samples_;
    Vec3 centroid_;
};

} // namespace

Plane midsagittal_plane(const VoxelGrid& grid, const Mask& mask)
{
    require_voxels(grid, "mask", mask.size());
    const Symmetry symmetry(grid, mask);
    constexpr double degree = std::numbers::pi / 180.0;
    constexpr double largest_tilt = 30.0 * degree;
    Pose best{};
    double most = symmetry.overlap(best);
    for (double step = 3.2; step > 0.04; step *= 0.5)
    {
        for (bool moved = true; moved;)
        {
            moved = false;
            for (int k = 0; k < 6; ++k)
            {
                Pose next = best;
                next[k / 2] += (k % 2 == 0 ? step : -step) * (k < 2 ? 1.0 : degree);
                const double overlap = symmetry.overlap(next);
                if (overlap > most && std::abs(next[1]) <= largest_tilt && std::abs(next[2]) <= largest_tilt)
                {
                    most = overlap;
                    best = next;
                    moved = true;
                }
            }
        }
    }
    return symmetry.plane(best);
}

} // namespace corticle::imaging
