// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/smoothing.hpp"

#include "corticle/imaging/grid_lines.hpp"

#include <cmath>

namespace corticle::imaging
{

namespace
{

/// Weights of a voxel and of those at 1, 2, ... steps; the two-sided sum is 1. Integrals over the voxel, so that a
/// Gaussian narrower than a voxel is one too.
std::vector<double> gaussian_weights(double sigma, double step)
{
    const auto reach = static_cast<std::int64_t>(std::ceil(4.0 * sigma / step));
    std::vector<double> weights;
    double sum = 0.0;
    const auto integral = [&](double steps) { return 0.5 * std::erf(steps * step / (sigma * std::sqrt(2.0))); };
    for (std::int64_t k = 0; k <= reach; ++k)
    {
        weights.push_back(integral(static_cast<double>(k) + 0.5) - integral(static_cast<double>(k) - 0.5));
        sum += (k == 0 ? 1.0 : 2.0) * weights.back();
    }
    for (double& weight : weights)
    {
        weight /= sum;
    }
    return weights;
}

} // namespace

void smooth_gaussian(const VoxelGrid& grid, double sigma, std::vector<float>& values)
{
    require_voxels(grid, "values", values.size());
    const Vec3 edges = voxel_edges(grid.frame);
    for (int axis = 0; axis < 3 && sigma > 0.0; ++axis)
    {
        const std::vector<double> weights = gaussian_weights(sigma, edges[axis]);
        const std::int64_t length = grid.size[axis];
        const std::int64_t stride = grid.stride(axis);
        const auto reach = static_cast<std::int64_t>(weights.size()) - 1;
        for_lines(grid, axis,
                  [&](std::int64_t first)
                  {
                      std::vector<double> line(static_cast<std::size_t>(length + 2 * reach), 0.0);
                      for (std::int64_t k = 0; k < length; ++k)
                      {
                          line[k + reach] = static_cast<double>(values[first + k * stride]);
                      }
                      for (std::int64_t k = 0; k < length; ++k)
                      {
                          double sum = weights[0] * line[k + reach];
                          for (std::int64_t d = 1; d <= reach; ++d)
                          {
                              sum += weights[d] * (line[k + reach - d] + line[k + reach + d]);
                          }
                          values[first + k * stride] = static_cast<float>(sum);
                      }
                  });
    }
    parallel_for(grid.count(),
                 [&](std::int64_t voxel)
                 {
                     if (grid.is_outermost(voxel))
                     {
                         values[voxel] = 0.0F;
                     }
                 });
}

} // namespace corticle::imaging
