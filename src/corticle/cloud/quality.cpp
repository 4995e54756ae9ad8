// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/quality.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace corticle::cloud
{

namespace
{

/// Square of the distance of the closest pair, among those closer than a cell of the grid [mm²].
double closest_pair_squared(std::span<const Vec3> positions, const CellGrid& grid)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return parallel_reduce(
        static_cast<std::int64_t>(positions.size()), infinity,
        [&](std::int64_t begin, std::int64_t end)
        {
            double closest = infinity;
            for (std::int64_t i = begin; i < end; ++i)
            {
                grid.near(positions[i], [&](std::int32_t j, const Vec3& p)
                          { closest = j == i ? closest : std::min(closest, squared_norm(p - positions[i])); });
            }
            return closest;
        },
        [](double& total, double part) { total = std::min(total, part); });
}

} // namespace

CloudQuality measure_quality(const Cloud& cloud)
{
    CloudQuality quality;
    if (cloud.positions.empty())
    {
        return quality;
    }
    require_size("volumes of the cloud", cloud.volumes.size(), cloud.positions.size());
    require_positive("spacing of the cloud [mm]", cloud.spacing);
    const CellGrid grid(cloud.positions, 1.5 * cloud.spacing);
    quality.closest_pair_spacings = std::sqrt(closest_pair_squared(cloud.positions, grid)) / cloud.spacing;
    quality.smallest_volume = *std::min_element(cloud.volumes.begin(), cloud.volumes.end());
    quality.largest_volume = *std::max_element(cloud.volumes.begin(), cloud.volumes.end());
    quality.mean_volume =
        std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0) / static_cast<double>(cloud.volumes.size());
    return quality;
}

} // namespace corticle::cloud
