// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/distance_transform.hpp"

#include "corticle/imaging/grid_lines.hpp"

#include <algorithm>
#include <limits>

namespace corticle::imaging
{

namespace
{

constexpr float nowhere = 1e18F; ///< [mm²]

/// Replaces values f by min_q f(q) + step² (p - q)², for a line of voxels.
class LineTransform
{
  public:
    explicit LineTransform(std::int64_t length)
        : values_(static_cast<std::size_t>(length)), vertex_(values_.size()), from_(values_.size() + 1)
    {
    }

    void apply(float* line, std::int64_t stride, double step)
    {
        const auto length = static_cast<std::int64_t>(values_.size());
        for (std::int64_t p = 0; p < length; ++p)
        {
            values_[p] = static_cast<double>(line[p * stride]);
        }
        const std::int64_t parabolas = lower_envelope(length, step * step);
        std::int64_t at = 0;
        for (std::int64_t p = 0; p < length && parabolas > 0; ++p)
        {
            while (at + 1 < parabolas && from_[at + 1] < static_cast<double>(p))
            {
                ++at;
            }
            const double offset = step * static_cast<double>(p - vertex_[at]);
            line[p * stride] = static_cast<float>(values_[vertex_[at]] + offset * offset);
        }
    }

  private:
    std::int64_t lower_envelope(std::int64_t length, double step2)
    {
        std::int64_t count = 0;
        for (std::int64_t q = 0; q < length; ++q)
        {
            if (values_[q] >= static_cast<double>(nowhere))
            {
                continue;
            }
            double from = -std::numeric_limits<double>::infinity();
            while (count > 0)
            {
                from = crossing(vertex_[count - 1], q, step2);
                if (from > from_[count - 1])
                {
                    break;
                }
                --count;
                from = -std::numeric_limits<double>::infinity();
            }
            vertex_[count] = q;
            from_[count] = from;
            ++count;
        }
        return count;
    }

    /// Where the parabola at q comes below the one at r < q.
    double crossing(std::int64_t r, std::int64_t q, double step2) const
    {
        const auto a = static_cast<double>(r);
        const auto b = static_cast<double>(q);
        return 0.5 * (a + b + (values_[q] - values_[r]) / (step2 * (b - a)));
    }

    std::vector<double> values_;
    std::vector<std::int64_t> vertex_; ///< of the parabolas of the envelope
    std::vector<double> from_;         ///< where each begins
};

} // namespace

std::vector<float> squared_distance_to(const VoxelGrid& grid, const Mask& mask, std::uint8_t value)
{
    require_voxels(grid, "mask", mask.size());
    std::vector<float> distance(mask.size());
    std::transform(mask.begin(), mask.end(), distance.begin(),
                   [&](std::uint8_t voxel) { return voxel == value ? 0.0F : nowhere; });
    const Vec3 edges = voxel_edges(grid.frame);
    for (int axis = 0; axis < 3; ++axis)
    {
        for_lines(grid, axis,
                  [&](std::int64_t first)
                  {
                      LineTransform transform(grid.size[axis]);
                      transform.apply(&distance[first], grid.stride(axis), edges[axis]);
                  });
    }
    return distance;
}

} // namespace corticle::imaging
